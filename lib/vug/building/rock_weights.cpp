// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/building/rock_weights.h>
#include <vug/field/material_source.h>
#include <vug/mesh/rock_weights.h>
#include <vug/meshing/project.h>
#include <vug/volume/band.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::building {
namespace {

std::vector<float> weights_of(const std::vector<field::MaterialMix>& mixes,
                              const std::string& material) {
  std::vector<float> out;
  out.reserve(mixes.size());
  for (const field::MaterialMix& mix : mixes)
    out.push_back(static_cast<float>(mix.weight(material)));
  return out;
}

/// Numbers from 1 in the order of `names`, 0 without a material.
std::vector<int32_t> numbers_of(const std::vector<field::MaterialMix>& mixes,
                                const std::vector<std::string>& names) {
  std::vector<int32_t> out;
  out.reserve(mixes.size());
  for (const field::MaterialMix& mix : mixes) {
    const field::RockMaterial* most = mix.dominant();
    const auto at = most ? std::lower_bound(names.begin(), names.end(), most->name) : names.end();
    out.push_back(most ? static_cast<int32_t>(at - names.begin()) + 1 : 0);
  }
  return out;
}

/// The nearest points of the surface, at most a voxel away. In single precision, so that a point
/// does not depend on the other ones.
std::vector<Vec3f> moved_to_surface(const shot::VolumePlan& plan,
                                    const std::vector<Vec3f>& points) {
  constexpr size_t kChunk = 1024;
  constexpr double kTolerance = 1e-5;
  std::vector<Vec3f> out(points.size());
  parallel_for((points.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(chunk * kChunk);
    const auto end =
        begin + static_cast<std::ptrdiff_t>(std::min(kChunk, points.size() - chunk * kChunk));
    const std::vector<Vec3d> starts(begin, end);
    meshing::SurfaceProjector projector(plan.field, starts, kInfinity);
    const auto placed =
        projector.project(starts, {.reach = plan.voxel, .tolerance = kTolerance, .steps = 4});
    for (size_t i = 0; i < placed.size(); ++i) out[chunk * kChunk + i] = Vec3f(placed[i].point);
  });
  return out;
}

}  // namespace

std::vector<std::string> materials_of(const shot::VolumePlan& plan) {
  std::vector<std::string> out;
  if (plan.source_mesh) return out;
  for (const field::RockMaterialPtr& each : field::materials_of(plan.field))
    out.push_back(each->name);
  return out;
}

void add_rock_weights(mesh::Mesh& mesh, const shot::VolumePlan& plan, bool polished) {
  const std::vector<std::string> names = materials_of(plan);
  if (names.empty()) return;
  const std::vector<field::MaterialMix> mixes = field::materials_at(
      plan.field, polished ? mesh.positions : moved_to_surface(plan, mesh.positions));
  for (const std::string& name : names)
    mesh.attributes.push_back({mesh::weight_attribute(name), 1, weights_of(mixes, name)});
}

std::vector<volume::Grid> rock_grids(const shot::VolumePlan& plan,
                                     const volume::LevelSet& level_set, const std::string& prefix,
                                     uint64_t memory) {
  const std::vector<std::string> names = materials_of(plan);
  if (names.empty()) return {};
  // Positions, mixes, and for each name the values and the grid.
  const double each = 16 + sizeof(field::MaterialMix) + 10 * static_cast<double>(names.size() + 1);
  require_memory(each * static_cast<double>(level_set.statistics().active_voxels), memory,
                 fmt::format("the grids of the materials of '{}'", plan.name), "use larger voxels");
  const std::vector<field::MaterialMix> mixes =
      field::materials_at(plan.field, volume::band_positions(level_set));
  const volume::Metadata notes = {{kMaterialNames, fmt::format("{}", fmt::join(names, ","))}};
  std::vector<volume::Grid> out;
  out.push_back(volume::band_grid(level_set, numbers_of(mixes, names))
                    .named(prefix + kMaterialNumber)
                    .with(notes));
  for (const std::string& name : names)
    out.push_back(volume::band_grid(level_set, weights_of(mixes, name))
                      .named(prefix + mesh::weight_attribute(name))
                      .stored_as_half(plan.half));
  return out;
}

std::vector<std::string> add_rock_weights(volume::Points& points, const shot::CellsPlan& plan,
                                          const cells::Network& network) {
  std::set<std::string> all;
  for (const shot::MeshPtr& support : plan.on)
    if (support->volume)
      for (const std::string& name : materials_of(*support->volume)) all.insert(name);
  const std::vector<std::string> names(all.begin(), all.end());
  if (names.empty()) return names;
  std::vector<field::MaterialMix> mixes(network.size());
  for (size_t object = 0; object < plan.on.size(); ++object) {
    const shot::MeshPlan& support = *plan.on[object];
    if (!support.volume || materials_of(*support.volume).empty()) continue;
    std::vector<size_t> cells;
    std::vector<Vec3f> positions;
    for (size_t i = 0; i < network.size(); ++i)
      if (network.object[i] == object) cells.push_back(i), positions.push_back(network.position[i]);
    const std::vector<field::MaterialMix> own =
        field::materials_at(support.volume->field, positions);
    for (size_t k = 0; k < cells.size(); ++k) mixes[cells[k]] = own[k];
  }
  if (!points.find(kMaterialNumber))
    points.attributes.push_back({kMaterialNumber, numbers_of(mixes, names)});
  for (const std::string& name : names)
    points.attributes.push_back({mesh::weight_attribute(name), weights_of(mixes, name)});
  return names;
}

}  // namespace vug::building
