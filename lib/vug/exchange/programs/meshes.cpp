// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(meshes) {
  Program program = make_program("meshes", "Programs that read only meshes: .obj and .ply");
  program.formats = {"obj", "ply"};
  program.points_format = "ply";
  return program;
}
