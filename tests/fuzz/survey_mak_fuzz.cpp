// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .mak file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_mak) { vug::survey::fuzz("mak", data, size); }
