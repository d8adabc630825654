#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(gltf) {
  Program made = make_program("gltf", "Any glTF reader, such as web pages: metres, y up");
  made.formats = {"glb"};
  return made;
}
