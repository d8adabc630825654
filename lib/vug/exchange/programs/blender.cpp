// Blender 3.4 and later: its importer turns glTF to z up, but takes .vdb and .ply as they are.
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(blender) {
  Program made = make_program("blender", "Blender: glTF, volumes with z up, points as .ply");
  made.space = {UpAxis::z, 1};
  made.formats = {"glb"};
  made.options.instancing = false;  // EXT_mesh_gpu_instancing is read from 3.6 on
  made.options.emission_scale = 1;  // it takes the strength of shining surfaces as it stands
  made.points_format = "ply";
  return made;
}
