// SPDX-License-Identifier: Apache-2.0
#include <vug/building/make_mesh.h>
#include <vug/building/rock_weights.h>
#include <vug/building/surface_labels.h>
#include <vug/building/tile_surface.h>
#include <vug/facade/semantics.h>

namespace vug::building {

meshing::TileMesh make_tile_mesh(const shot::MeshPlan& plan, const volume::LevelSet& surface,
                                 const field::Field& field, const volume::LatticeBox& tile,
                                 Progress& progress) {
  shot::MeshPlan whole_polygons = plan;
  whole_polygons.adaptivity = 0;
  progress.begin("small features");
  std::vector<volume::SmallFeature> small;
  if (plan.topology == shot::SmallTopology::clean)
    small = volume::find_small_features(surface, &field, progress);
  const meshing::PolygonizeResult whole =
      polygonize_plan(whole_polygons, {surface, small, &field}, true, nullptr, progress);
  meshing::TileMesh out = meshing::tile_mesh(whole.mesh, *whole.keys, tile);
  if (!plan.elements.empty()) facade::add_semantics(out.mesh, plan.elements);
  add_labels(out.mesh, plan.labels);
  add_rock_weights(out.mesh, *plan.volume, plan.polish);
  progress.end();
  return out;
}

}  // namespace vug::building
