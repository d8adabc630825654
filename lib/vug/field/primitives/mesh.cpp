// SPDX-License-Identifier: Apache-2.0
// The exact distance to a closed mesh of triangles; see mesh/distance.h.
#include <vug/field/opaque.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/format.h>
#include <vug/mesh/topology.h>

#include <fmt/format.h>

namespace vug::field {
namespace {

struct MeshSource {
  mesh::MeshDistance distance;

  Gradient sample(const Vec3d& p) const {
    const mesh::MeshDistance::Closest closest = distance.closest(p);
    const Vec3d away = p - closest.point;
    const double sign = away.dot(closest.normal) < 0 ? -1 : 1;
    // Next to the surface the difference of two close points does not determine a direction.
    const bool touching = closest.distance <= 1e-9 * (1 + p.length());
    return {sign * closest.distance, touching ? closest.normal : away * (sign / closest.distance)};
  }
};

struct MeshFile {
  std::filesystem::path file;
  double scale = 1;

  static void describe(Schema<MeshFile>& s) {
    s.doc("The solid inside a closed mesh of triangles.")
        .cite("baerentzen2005")
        .param("file", &MeshFile::file,
               {.doc = "an OBJ, PLY or STL file, in metres", .required = true})
        .param("scale", &MeshFile::scale,
               {.doc = "metres per unit of the file, e.g. 0.01 for centimetres",
                .min = 0,
                .above_min = true});
  }
};

Field solid(const MeshFile& params) {
  mesh::Mesh mesh = mesh::read_mesh(params.file);
  for (Vec3f& p : mesh.positions) p *= static_cast<float>(params.scale);
  const mesh::Topology topology = mesh::inspect(mesh);
  if (!topology.closed() || topology.misoriented_edges > 0 || mesh.triangles.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' does not bound a solid: it has {} triangles, {} open edges, {} "
                            "edges with more than two triangles and {} edges whose sides disagree",
                            params.file.string(), mesh.triangles.size(), topology.boundary_edges,
                            topology.nonmanifold_edges, topology.misoriented_edges),
                {}, "close the mesh and orient it consistently");
  const mesh::MeshDistance distance(mesh);
  Traits traits;
  traits.bounds = distance.bounds();
  return Field(std::make_shared<OpaqueNode<MeshSource>>("mesh", traits, MeshSource{distance}));
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(mesh) { return field_kind<MeshFile>("mesh", "primitive", solid); }
