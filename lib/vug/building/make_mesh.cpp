// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/make_mesh.h>
#include <vug/building/memory_estimate.h>
#include <vug/building/rock_weights.h>
#include <vug/building/surface_labels.h>
#include <vug/facade/semantics.h>
#include <vug/mesh/refine.h>
#include <vug/meshing/polygonize.h>
#include <vug/shot/cells_plan.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace vug::building {

void add_colors(mesh::Mesh& mesh, const paint::Paint& paint, const field::SampledGrid* solid) {
  std::vector<paint::EvalPoint> points(mesh.positions.size());
  for (size_t i = 0; i < points.size(); ++i)
    points[i] = {Vec3d(mesh.positions[i]), Vec3d(mesh.normals.at(i)).normalized(), solid};
  mesh::Attribute color{"Cd", 3, {}};
  color.values.reserve(3 * points.size());
  for (const Vec3f& rgb : paint::colors(paint, points))
    for (int c = 0; c < 3; ++c) color.values.push_back(rgb[c]);
  mesh.attributes.push_back(std::move(color));
}

meshing::PolygonizeResult polygonize_plan(const shot::MeshPlan& plan, const SampledSurface& surface,
                                          bool keys, PartCache* parts, Progress& progress) {
  const volume::LevelSet meshed =
      plan.topology == shot::SmallTopology::clean
          ? volume::without_features(surface.level_set, surface.small_features)
          : surface.level_set;
  meshing::PolygonizeOptions options;
  options.adaptivity = plan.adaptivity;
  options.polish = plan.polish;
  options.keys = keys;
  progress.begin("triangles");
  const field::Field* polished = plan.polish ? surface.exact : nullptr;
  return parts ? meshing::polygonize(meshed, polished, options, parts->polish, progress)
               : meshing::polygonize(meshed, polished, options, progress);
}

SurfaceMesh make_surface_mesh(const shot::MeshPlan& plan, const volume::LevelSet& surface,
                              uint64_t memory, Progress& progress, PartCache* parts) {
  const CancellableScope scope(progress);
  const shot::VolumePlan& volume = *plan.volume;
  // With the faces of the region, so that the polish keeps them flat.
  const field::Field field =
      volume.source_mesh ? field::Field()
                         : volume::field_in_region(volume.field, voxelize_options(volume, memory));
  const field::Field* exact = volume.source_mesh ? nullptr : &field;
  const auto active = static_cast<double>(surface.statistics().active_voxels);
  const double band = 2 * plan.volume->half_width;
  require_memory(meshing_bytes(active, band) +
                     label_bytes(active, band, shot::label_names(plan.labels).size()) +
                     rock_weight_bytes(active, band, materials_of(volume).size()),
                 memory, "the mesh");
  progress.begin("small features");
  std::vector<volume::SmallFeature> small = volume::find_small_features(surface, exact, progress);
  mesh::Mesh polygons = polygonize_plan(plan, {surface, small, exact}, false, parts, progress).mesh;
  progress.begin("components of the mesh");
  mesh::LargeComponents pieces = mesh::large_components(std::move(polygons), plan.smallest_piece);
  progress.begin("materials of the rock");
  add_rock_weights(pieces.mesh, volume, plan.polish);
  std::vector<mesh::Attribute> rock_weights = std::move(pieces.mesh.attributes);
  pieces.mesh.attributes.clear();
  progress.end();
  return {std::move(pieces), std::move(small), std::move(rock_weights)};
}

void add_attributes(SurfaceMesh& mesh, const shot::MeshPlan& plan,
                    const field::SampledGrid* solid) {
  if (plan.paint) add_colors(mesh.pieces.mesh, plan.paint, solid);
  if (!plan.elements.empty()) facade::add_semantics(mesh.pieces.mesh, plan.elements);
  add_labels(mesh.pieces.mesh, plan.labels);
  std::vector<mesh::Attribute>& attributes = mesh.pieces.mesh.attributes;
  attributes.insert(attributes.end(), std::make_move_iterator(mesh.rock_weights.begin()),
                    std::make_move_iterator(mesh.rock_weights.end()));
  mesh.rock_weights.clear();
}

mesh::LargeComponents make_mesh(const shot::MeshPlan& plan) {
  mesh::LargeComponents pieces = mesh::large_components(*plan.file_mesh, plan.smallest_piece);
  if (plan.paint) add_colors(pieces.mesh, plan.paint, nullptr);
  add_labels(pieces.mesh, plan.labels);
  return pieces;
}

mesh::Mesh merge_meshes(const std::vector<mesh::MeshPtr>& parts) {
  mesh::Mesh all;
  for (const mesh::MeshPtr& part : parts) {
    const auto first = static_cast<uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), part->positions.begin(), part->positions.end());
    all.normals.insert(all.normals.end(), part->normals.begin(), part->normals.end());
    for (const mesh::Triangle& t : part->triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    for (const mesh::Attribute& own : part->attributes) {
      const auto same = [&](const mesh::Attribute& each) {
        return each.name == own.name && each.arity == own.arity;
      };
      auto known = std::find_if(all.attributes.begin(), all.attributes.end(), same);
      if (known == all.attributes.end())
        known = all.attributes.insert(known, {own.name, own.arity, {}});
      known->values.resize(first * static_cast<size_t>(own.arity));
      known->values.insert(known->values.end(), own.values.begin(), own.values.end());
    }
  }
  for (mesh::Attribute& each : all.attributes)
    each.values.resize(all.positions.size() * static_cast<size_t>(each.arity));
  if (all.normals.size() != all.positions.size()) all.normals.clear();
  return all;
}

mesh::MeshPtr refine_for_cells(const shot::CellsPlan& plan, const mesh::Mesh& mesh,
                               uint64_t memory) {
  // Includes its vertices (half as many) and the table of edges.
  constexpr uint64_t kTriangleBytes = 120;
  try {
    return std::make_shared<const mesh::Mesh>(
        mesh::refined(mesh, plan.spacing, static_cast<size_t>(memory / kTriangleBytes)));
  } catch (const Error& error) {
    throw error.at(plan.spacing_where);
  }
}

}  // namespace vug::building
