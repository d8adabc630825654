#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(maya) {
  Program made = make_program("maya", "Maya: USD, centimetres, y up");
  made.space = {UpAxis::y, 0.01};
  made.formats = {"usda"};
  return made;
}
