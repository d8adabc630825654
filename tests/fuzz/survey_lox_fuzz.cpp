// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .lox file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_lox) { vug::survey::fuzz("lox", data, size); }
