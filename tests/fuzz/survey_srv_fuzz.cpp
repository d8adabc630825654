// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .srv file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(survey_srv) { vug::survey::fuzz("srv", data, size); }
