// SPDX-License-Identifier: Apache-2.0
// Any recipe of cells is rejected with error messages, or its cells run for a few steps on a box.
#include "target.h"

#include <vug/base/error.h>
#include <vug/building/cell_layer.h>
#include <vug/loading/load.h>
#include <vug/mesh/shapes.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

VUG_FUZZ_TARGET(recipe) {
  using namespace vug;
  const std::string recipe(reinterpret_cast<const char*>(data), size);
  if (recipe.find('}') != std::string::npos) return;  // only the contents of the block
  const std::string text =
      "volume rock = level_set(sphere(1m), voxel: 20cm)\nmesh wall on rock {}\n"
      "cells skin on wall { spacing 40cm  run " +
      recipe + "\n}\n";
  static const mesh::MeshPtr box =
      std::make_shared<const mesh::Mesh>(mesh::box_mesh(Box3d(Vec3d(-1), Vec3d(1, 0.5, 1))));
  try {
    const loading::Loaded loaded = loading::load_text(text, "fuzz.vug");
    if (!loaded.usable()) return;
    for (const shot::MeshPtr& mesh : loaded.shot.meshes) {
      if (!mesh->cells) continue;
      shot::CellsPlan plan = *mesh->cells;
      if (!plan.from.empty()) continue;
      plan.steps = std::min(plan.length(), 6);
      plan.relax = std::min(plan.relax.value_or(2), 5);
      building::make_cell_layer(plan, {{box, nullptr}}, uint64_t{1} << 22, Progress::none());
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) std::abort();
  }
}
