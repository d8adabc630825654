// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .3d file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_3d) { vug::survey::fuzz("3d", data, size); }
