// SPDX-License-Identifier: Apache-2.0
// Blender 3.4 and later: its importer converts glTF to z up, but reads .vdb and .ply unchanged.
#include <vug/exchange/program.h>

VUG_EXCHANGE_PROGRAM(blender) {
  Program program = make_program("blender", "Blender: glTF, volumes with z up, points as .ply");
  program.space = {UpAxis::z, 1};
  program.formats = {"glb"};
  program.options.instancing = false;  // EXT_mesh_gpu_instancing is supported from 3.6 on.
  program.options.emission_scale =
      1;  // It reads the strength of emissive surfaces without conversion.
  program.points_format = "ply";
  return program;
}
