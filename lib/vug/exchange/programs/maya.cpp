// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(maya) {
  Program program = make_program("maya", "Maya: USD, centimetres, y up");
  program.space = {UpAxis::y, 0.01};
  program.formats = {"usda"};
  return program;
}
