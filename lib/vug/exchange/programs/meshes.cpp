#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(meshes) {
  Program made = make_program("meshes", "Programs that read only meshes: .obj and .ply");
  made.formats = {"obj", "ply"};
  made.points_format = "ply";
  return made;
}
