#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(houdini) {
  Program made = make_program("houdini", "Houdini: USD, volumes and points as .vdb, metres, y up");
  made.space = {UpAxis::y, 1};
  made.formats = {"usda"};
  return made;
}
