#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(unreal) {
  Program made = make_program("unreal", "Unreal Engine: USD, centimetres, z up");
  made.space = {UpAxis::z, 0.01};
  made.formats = {"usda"};
  return made;
}
