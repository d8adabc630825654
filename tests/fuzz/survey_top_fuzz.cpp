// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .top file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_top) { vug::survey::fuzz("top", data, size); }
