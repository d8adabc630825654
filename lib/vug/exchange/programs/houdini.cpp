// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(houdini) {
  Program program =
      make_program("houdini", "Houdini: USD, volumes and points as .vdb, metres, y up");
  program.space = {UpAxis::y, 1};
  program.formats = {"usda"};
  return program;
}
