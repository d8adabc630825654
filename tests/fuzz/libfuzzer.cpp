// SPDX-License-Identifier: Apache-2.0
// The entry point that libFuzzer calls; it runs the only target of the program.
#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const vug::fuzzing::Target target = vug::fuzzing::targets().begin()->second;
  target(data, size);
  return 0;
}
