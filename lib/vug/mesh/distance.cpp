// SPDX-License-Identifier: Apache-2.0
#include <vug/base/digester.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/mesh/box_tree.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/triangle.h>
#include <vug/mesh/weld.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {

struct MeshDistance::Tree {
  std::vector<std::array<Vec3d, 3>> triangles;
  /// Unnormalised pseudonormals by feature: three corners, three edges, the face.
  std::vector<std::array<Vec3d, 7>> normals;
  BoxTree boxes;
};

MeshDistance::MeshDistance(const Mesh& given) {
  // Unwelded seams would hide neighbours from the pseudonormals.
  const Mesh mesh = welded(given);
  const size_t count = mesh.triangles.size();
  auto tree = std::make_shared<Tree>();
  tree->triangles.resize(count);
  tree->normals.resize(count);
  const std::vector<Vec3d> at_vertex = vertex_pseudonormals(mesh);
  bool any_area = false;
  std::vector<Box3d> boxes(count);
  for (size_t face = 0; face < count; ++face) {
    tree->triangles[face] = corners(mesh, face);
    const Vec3d normal = double_area_vector(mesh, face).normalized();
    any_area = any_area || normal != Vec3d(0);
    tree->normals[face][6] = normal;
    for (size_t k = 0; k < 3; ++k) {
      tree->normals[face][k] = at_vertex[mesh.triangles[face][k]];
      boxes[face].extendBy(tree->triangles[face][k]);
    }
  }
  if (!any_area)
    throw Error(ErrorCode::bad_input, "no triangle of the mesh has an area", {},
                "a distance requires a closed surface");
  const Edges edges = find_edges(mesh);
  for (const Edge& edge : edges.edges) {
    const uint32_t* first = edges.half_edges.data() + edge.begin;
    Vec3d sum(0);
    for (uint32_t i = 0; i < edge.count; ++i) sum += tree->normals[first[i] / 3][6];
    for (uint32_t i = 0; i < edge.count; ++i) tree->normals[first[i] / 3][3 + first[i] % 3] = sum;
  }
  tree->boxes = BoxTree(boxes);
  tree_ = std::move(tree);
}

MeshDistance::Closest MeshDistance::closest(const Vec3d& p) const {
  const Tree& tree = *tree_;
  double best = kInfinity;
  uint32_t face = 0;
  NearestOnTriangle nearest;
  tree.boxes.visit_nearest(p, best, [&](uint32_t candidate) {
    const NearestOnTriangle here = nearest_on_triangle(p, tree.triangles[candidate]);
    const double squared = (here.point - p).length2();
    // The lower number wins among equal distances (at a shared edge or corner), so the result is
    // unique.
    if (squared < best || (squared == best && candidate < face)) {
      best = squared;
      face = candidate;
      nearest = here;
    }
    return best;
  });
  const Vec3d normal = tree.normals[face][static_cast<size_t>(nearest.feature)];
  return {nearest.point, std::sqrt(best), face, normal.normalized()};
}

Digest MeshDistance::digest() const { return digest_of(tree_->triangles); }

double MeshDistance::signed_distance(const Vec3d& p) const {
  const Closest c = closest(p);
  return (p - c.point).dot(c.normal) < 0 ? -c.distance : c.distance;
}

const Box3d& MeshDistance::bounds() const { return tree_->boxes.bounds(); }

}  // namespace vug::mesh
