// SPDX-License-Identifier: Apache-2.0
#include <vug/building/rock_weights.h>
#include <vug/building/surface_labels.h>
#include <vug/building/tile_surface.h>
#include <vug/facade/semantics.h>
#include <vug/meshing/polygonize.h>
#include <vug/volume/small_features.h>

namespace vug::building {

meshing::TileMesh make_tile_mesh(const shot::MeshPlan& plan, const volume::LevelSet& surface,
                                 const field::Field& field, const volume::LatticeBox& tile,
                                 Progress& progress) {
  const bool clean = plan.topology == shot::SmallTopology::clean;
  progress.begin("small features");
  const volume::LevelSet meshed =
      clean ? volume::without_features(surface,
                                       volume::find_small_features(surface, &field, progress))
            : surface;
  meshing::PolygonizeOptions options;
  options.polish = plan.polish;
  options.keys = true;
  progress.begin("triangles");
  const meshing::PolygonizeResult whole =
      meshing::polygonize(meshed, plan.polish ? &field : nullptr, options, progress);
  meshing::TileMesh out = meshing::tile_mesh(whole.mesh, *whole.keys, tile);
  if (!plan.elements.empty()) facade::add_semantics(out.mesh, plan.elements);
  add_labels(out.mesh, plan.labels);
  add_rock_weights(out.mesh, *plan.volume);
  progress.end();
  return out;
}

}  // namespace vug::building
