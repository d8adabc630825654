// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .th file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_th) { vug::survey::fuzz("th", data, size); }
