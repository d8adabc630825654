// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .svx file of a survey.
#include "survey_fuzz.h"
#include "target.h"

VUG_FUZZ_TARGET(svx) { vug::survey::fuzz("svx", data, size); }
