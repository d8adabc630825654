// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/rescatter.h>

#include <fmt/format.h>

namespace vug::shot {
namespace {

MeshPtr mesh_of(const CellsPtr& cells) {
  MeshPlan plan = *cells->on.front();
  plan.name = cells->name;
  plan.cells = cells;
  plan.support = 0;
  return std::make_shared<const MeshPlan>(std::move(plan));
}

/// The plain mesh of the level set of a displaced mesh.
MeshPtr rebuilt(const CellsPtr& cells) {
  const MeshPtr& below = cells->on.front();
  VolumePlan volume;
  volume.name = cells->name;
  volume.where = cells->where;
  volume.source_mesh = mesh_of(cells);
  volume.voxel = below->volume->voxel;
  volume.half_width = below->volume->half_width;
  MeshPlan mesh = *below;
  mesh.name = cells->name;
  mesh.volume = std::make_shared<const VolumePlan>(std::move(volume));
  return std::make_shared<const MeshPlan>(std::move(mesh));
}

}  // namespace

CellsPtr divide_run(CellsPlan plan) {
  const int64_t parts = int64_t{1} + plan.rescatter, steps = plan.length();
  const std::string name = plan.name;
  const RandomKey key = plan.key;
  CellsPtr before;
  for (int64_t part = 0; part < parts; ++part) {
    if (part > 0) {
      plan.on = {rebuilt(before)};
      plan.before = before;
      plan.first_step = *before->steps;
      plan.key = key.at("rescatter").at(static_cast<uint64_t>(part));
    }
    plan.name = part + 1 < parts ? fmt::format("{}, part {}", name, part + 1) : name;
    plan.steps = static_cast<int>(steps * (part + 1) / parts);
    before = std::make_shared<const CellsPlan>(plan);
  }
  return before;
}

}  // namespace vug::shot
