// SPDX-License-Identifier: Apache-2.0
#include <vug/building/cell_points.h>
#include <vug/building/rock_weights.h>
#include <vug/mesh/rock_weights.h>
#include <vug/volume/io.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::building {
namespace {

constexpr const char* kStep = "vug:step";
constexpr const char* kKeep = "vug:keep";
constexpr const char* kExact = "exact";

}  // namespace

volume::Grid cell_points(const shot::CellsPlan& plan, const CellLayer& layer,
                         cells::PointFormat keep) {
  volume::Points points = cells::to_points(layer.simulation, keep);
  const bool exact = keep == cells::PointFormat::exact;
  if (plan.half && !exact)
    for (volume::PointAttribute& each : points.attributes) each.half = true;
  volume::Metadata notes = {{kStep, int64_t{layer.simulation.step()}},
                            {kKeep, std::string(exact ? kExact : "shown")}};
  if (!exact)
    if (const auto materials = add_rock_weights(points, plan, layer.network()); !materials.empty())
      notes[kMaterialNames] = fmt::format("{}", fmt::join(materials, ","));
  return volume::point_grid(points, cells::voxel_of_points(layer.network()))
      .named(plan.name)
      .with(notes);
}

void restore_cells(const volume::Grid& grid, cells::Simulation& simulation) {
  const volume::Metadata metadata = grid.metadata();
  const auto step = metadata.find(kStep);
  const auto* done = step == metadata.end() ? nullptr : std::get_if<int64_t>(&step->second);
  const auto keep = metadata.find(kKeep);
  const bool exact = keep != metadata.end() && keep->second == volume::MetaValue(kExact);
  volume::Points points = volume::points(grid);
  if (metadata.count(kMaterialNames))  // They belong to the rock, not to the state of the cells.
    std::erase_if(points.attributes, [](const volume::PointAttribute& each) {
      return each.name == kMaterialNumber || mesh::material_of_attribute(each.name);
    });
  // Tolerance: a step of 16-bit quantisation along each axis, and the rounding of floats.
  float far = 0;
  for (const Vec3f& p : points.position)
    far = std::max({far, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double apart = 2 * (grid.voxel_size().x / 65535 + static_cast<double>(far) * 0x1p-23);
  cells::restore(simulation, points, done ? static_cast<int>(*done) : 0,
                 exact ? cells::PointFormat::exact : cells::PointFormat::interchange, apart);
}

std::optional<volume::Grid> initial_points(const shot::CellsPlan& plan) {
  if (plan.from.empty()) return std::nullopt;
  try {
    std::optional<volume::Grid> found;
    for (const volume::Grid& grid : volume::read(plan.from))
      if (volume::is_points(grid) && (!found || grid.name() == plan.name)) found = grid;
    if (found) return found;
    throw Error(ErrorCode::bad_input, fmt::format("'{}' contains no points", plan.from.string()),
                {}, "vug build writes points unless 'files' of the cells excludes them");
  } catch (const Error& error) {
    throw error.at(plan.where);
  }
}

}  // namespace vug::building
