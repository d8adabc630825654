// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(unreal) {
  Program program = make_program("unreal", "Unreal Engine: USD, centimetres, z up");
  program.space = {UpAxis::z, 0.01};
  program.formats = {"usda"};
  return program;
}
