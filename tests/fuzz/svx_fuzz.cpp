// SPDX-License-Identifier: Apache-2.0
// Any bytes as a .svx file of a survey.
#include "survey_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  vug::survey::fuzz("svx", data, size);
  return 0;
}
