#include <vug/building/apply_cells.h>
#include <vug/cells/transfer_to_mesh.h>
#include <vug/mesh/clip.h>
#include <vug/mesh/displacement.h>

#include <fmt/format.h>

namespace vug::building {
namespace {

/// Metres in a unit that someone makes out who has written nonsense.
void require_near(const mesh::Mesh& bare, const mesh::Mesh& moved) {
  const double size = mesh::bounds(bare).size().length(), way = mesh::max_displacement(bare, moved);
  if (way > 10 * size)
    throw Error(ErrorCode::bad_input,
                fmt::format("cells move the surface by up to {:.3g} m, and all of it is {:.3g} m",
                            way, size),
                {}, "'height' is in metres; with 'move false' the mesh stays where it is");
}

}  // namespace

Worn wear(const mesh::Mesh& bare, const Skin& skin, const shot::CellsPlan& plan,
          Progress& progress) {
  Worn worn{bare, 0};
  if (bare.triangles.empty()) return worn;
  cells::TransferOptions options;
  options.move = plan.move;
  try {
    cells::transfer_to_mesh(skin.simulation, worn.mesh, options, progress);
    if (plan.move) require_near(bare, worn.mesh);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    throw error.at(plan.where);
  }
  if (plan.move) worn.turned = mesh::flipped_triangles(bare, worn.mesh);
  const mesh::Attribute* gone = mesh::find_attribute(worn.mesh, cells::kTransparent, 1);
  if (plan.holes && gone) worn.mesh = mesh::clip(worn.mesh, gone->values, 0.5F);
  return worn;
}

}  // namespace vug::building
