// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .dat file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_dat) { vug::survey::fuzz("dat", data, size); }
