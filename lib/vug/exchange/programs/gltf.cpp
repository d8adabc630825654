// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(gltf) {
  Program program = make_program("gltf", "Any glTF reader, such as web pages: metres, y up");
  program.formats = {"glb"};
  return program;
}
