#include <vug/base/memory.h>
#include <vug/meshing/polygonize.h>
#include <vug/session/make_mesh.h>
#include <vug/session/room.h>
#include <vug/volume/samples.h>

namespace vug::session {
namespace {

void add_colors(mesh::Mesh& mesh, const paint::Paint& paint, const volume::LevelSet& surface) {
  const auto solid = volume::samples(surface);
  std::vector<paint::Spot> spots(mesh.positions.size());
  for (size_t i = 0; i < spots.size(); ++i)
    spots[i] = {Vec3d(mesh.positions[i]), Vec3d(mesh.normals.at(i)).normalized(), solid.get()};
  mesh::Attribute color{"Cd", 3, {}};
  color.values.reserve(3 * spots.size());
  for (const Vec3f& rgb : paint::colors(paint, spots))
    for (int c = 0; c < 3; ++c) color.values.push_back(rgb[c]);
  mesh.attributes.push_back(std::move(color));
}

}  // namespace

mesh::LargePieces make_mesh(const MeshPlan& plan, const volume::LevelSet& surface, uint64_t memory,
                            Progress& progress) {
  meshing::PolygonizeOptions polygonize;
  polygonize.adaptivity = plan.adaptivity;
  polygonize.polish = plan.polish;
  const field::Field* exact = plan.polish ? &plan.volume->field : nullptr;
  const auto active = static_cast<double>(surface.statistics().active_voxels);
  require_memory(meshing_bytes(active, 2 * plan.volume->half_width), memory, "the mesh");
  mesh::LargePieces pieces = mesh::large_pieces(
      meshing::polygonize(surface, exact, polygonize, progress).mesh, plan.smallest_piece);
  if (plan.paint) add_colors(pieces.mesh, plan.paint, surface);
  return pieces;
}

}  // namespace vug::session
