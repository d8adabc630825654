// SPDX-License-Identifier: Apache-2.0
#include <vug/building/apply_cells.h>
#include <vug/cells/transfer_to_mesh.h>
#include <vug/mesh/clip.h>
#include <vug/mesh/displacement.h>

#include <fmt/format.h>

namespace vug::building {
namespace {

/// Rejects displacements that are far too large, usually due to wrong units.
void require_near(const mesh::Mesh& bare, const mesh::Mesh& moved) {
  const double size = mesh::bounds(bare).size().length(), way = mesh::max_displacement(bare, moved);
  if (way > 10 * size)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("cells displace the surface by up to {:.3g} m, but its size is only {:.3g} m",
                    way, size),
        {}, "'height' is in metres; 'move false' turns the displacement off");
}

}  // namespace

MeshWithCells apply_cells(const mesh::Mesh& bare, const CellLayer& layer,
                          const shot::CellsPlan& plan, Folds folds, Progress& progress) {
  MeshWithCells applied{bare, 0};
  if (bare.triangles.empty()) return applied;
  cells::TransferOptions options;
  options.move = plan.move;
  options.folds = folds == Folds::allow;
  try {
    progress.begin("attributes of the cells");
    applied.unfolded_vertices =
        cells::transfer_to_mesh(layer.simulation, applied.mesh, options, progress);
    if (plan.move) require_near(bare, applied.mesh);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    throw error.at(plan.where);
  }
  const mesh::Attribute* gone = mesh::find_attribute(applied.mesh, cells::kTransparent, 1);
  if (plan.holes && gone)
    applied.mesh = run_stage(progress, "cutting the holes of the cells",
                             [&] { return mesh::clip(applied.mesh, gone->values, 0.5F); });
  return applied;
}

}  // namespace vug::building
