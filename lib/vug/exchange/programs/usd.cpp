#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(usd) {
  Program made = make_program("usd", "Any USD reader: metres, y up");
  made.space = {UpAxis::y, 1};
  made.formats = {"usda"};
  return made;
}
