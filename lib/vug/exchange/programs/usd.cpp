// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(usd) {
  Program program = make_program("usd", "Any USD reader: metres, y up");
  program.space = {UpAxis::y, 1};
  program.formats = {"usda"};
  return program;
}
