// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .plt file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_plt) { vug::survey::fuzz("plt", data, size); }
