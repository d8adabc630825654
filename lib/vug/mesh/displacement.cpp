// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/displacement.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/retreat.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/sort_unique.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

double distance(const Vec3f& a, const Vec3f& b) { return (Vec3d(a) - Vec3d(b)).length(); }

Vec3d area_vector(const std::vector<Vec3f>& positions, const Triangle& triangle) {
  const Vec3d a(positions[triangle[0]]), b(positions[triangle[1]]), c(positions[triangle[2]]);
  return (b - a).cross(c - a);
}

/// The vertices of the triangles `faces`, ascending.
std::vector<uint32_t> vertices_of(const Mesh& mesh, const std::vector<uint32_t>& faces) {
  std::vector<uint32_t> vertices;
  for (const uint32_t face : faces)
    vertices.insert(vertices.end(), mesh.triangles[face].begin(), mesh.triangles[face].end());
  sort_unique(vertices);
  return vertices;
}

bool is_flipped(const std::vector<Vec3f>& before, const Mesh& after, uint32_t face) {
  const Triangle& triangle = after.triangles[face];
  return area_vector(before, triangle).dot(area_vector(after.positions, triangle)) < 0;
}

/// Whether the triangle faces against the surface around it.
bool opposes_surface(const Mesh& mesh, const Fans& fans, uint32_t face) {
  Vec3d around(0);
  for (const uint32_t v : mesh.triangles[face])
    around += vertex_pseudonormal(mesh, fans, v).normalized();
  return area_vector(mesh.positions, mesh.triangles[face]).dot(around) <= 0;
}

/// The list without the faces that do not oppose the surface.
std::vector<uint32_t> opposing(const std::vector<uint32_t>& faces, const Mesh& mesh,
                               const Fans& fans) {
  std::vector<uint32_t> list;
  for (const uint32_t face : faces)
    if (opposes_surface(mesh, fans, face)) list.push_back(face);
  return list;
}

/// A mesh whose vertices moved from `before`, with its flipped triangles.
class MovedMesh {
 public:
  MovedMesh(const std::vector<Vec3f>& before, Mesh& after)
      : before_(before), after_(after), fans_(after), flipped_(flipped_triangles(before, after)) {}

  const std::vector<uint32_t>& flipped() const { return flipped_; }
  std::vector<uint32_t> folded() const { return opposing(flipped_, after_, fans_); }

  /// The mean displacement of the corners of the triangles around the vertex.
  Vec3f mean_displacement(uint32_t vertex) const {
    Vec3f sum(0);
    for (const uint32_t face : fans_.at(vertex))
      for (const uint32_t corner : after_.triangles[face])
        sum += after_.positions[corner] - before_[corner];
    return sum / static_cast<float>(3 * fans_.at(vertex).size());
  }

  /// Finds the flipped triangles again after these vertices have moved.
  void update(const std::vector<uint32_t>& vertices) {
    for (const uint32_t v : vertices)
      flipped_.insert(flipped_.end(), fans_.at(v).begin(), fans_.at(v).end());
    sort_unique(flipped_);
    std::erase_if(flipped_, [&](uint32_t face) { return !is_flipped(before_, after_, face); });
  }

 private:
  const std::vector<Vec3f>& before_;
  const Mesh& after_;
  const Fans fans_;
  std::vector<uint32_t> flipped_;  ///< Ascending.
};

}  // namespace

double max_displacement(const Mesh& before, const Mesh& after) {
  return ordered_reduce(
      before.positions.size(), 0.0,
      [&](size_t v) { return distance(after.positions[v], before.positions[v]); },
      [](double a, double b) { return std::max(a, b); });
}

std::vector<uint32_t> flipped_triangles(const std::vector<Vec3f>& before, const Mesh& after) {
  std::vector<uint8_t> is(after.triangles.size());
  parallel_for(
      is.size(),
      [&](size_t face) { is[face] = is_flipped(before, after, static_cast<uint32_t>(face)); },
      4096);
  std::vector<uint32_t> flipped;
  for (uint32_t face = 0; face < is.size(); ++face)
    if (is[face]) flipped.push_back(face);
  return flipped;
}

std::vector<uint32_t> folded_triangles(const std::vector<Vec3f>& before, const Mesh& after) {
  const std::vector<uint32_t> flipped = flipped_triangles(before, after);
  return flipped.empty() ? flipped : opposing(flipped, after, Fans(after));
}

size_t prevent_folds(const std::vector<Vec3f>& before, Mesh& after, bool along_normals) {
  constexpr int kSmoothings = 30, kHalvings = 5;
  const std::vector<Vec3f> full = after.positions;
  std::vector<uint8_t> halvings(full.size(), 0);
  MovedMesh moved(before, after);
  for (int round = 0; !moved.flipped().empty(); ++round) {
    const bool smooths = round < kSmoothings, all = smooths && along_normals;
    const std::vector<uint32_t> vertices =
        vertices_of(after, all ? moved.flipped() : moved.folded());
    if (vertices.empty()) break;
    std::vector<Vec3f> smooth(vertices.size());
    for (size_t i = 0; i < vertices.size(); ++i) smooth[i] = moved.mean_displacement(vertices[i]);
    for (size_t i = 0; i < vertices.size(); ++i) {
      const uint32_t v = vertices[i];
      if (!smooths && halvings[v] <= kHalvings) ++halvings[v];
      const float share = halvings[v] > kHalvings ? 0 : std::ldexp(1.0f, -halvings[v]);
      after.positions[v] = before[v] + smooth[i] * share;
    }
    moved.update(vertices);
  }
  size_t changed = 0;
  for (size_t v = 0; v < full.size(); ++v) changed += full[v] != after.positions[v];
  return changed;
}

void prevent_crossings(const std::vector<Vec3f>& before, Mesh& after) {
  const std::vector<FacePair> crossings = self_intersections(after);
  if (crossings.empty()) return;
  std::vector<uint32_t> crossing;
  for (const auto& [low, high] : crossings) crossing.insert(crossing.end(), {low, high});
  sort_unique(crossing);
  Mesh bare;
  bare.positions = before;
  bare.triangles = after.triangles;
  if (self_intersections_of(crossing, bare, BoxTree(triangle_boxes(bare))).empty())
    retreat(before, after, crossings);
}

}  // namespace vug::mesh
