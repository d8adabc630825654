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

/// For each of `vertices`, the mean displacement of the corners of the triangles around it.
std::vector<Vec3f> smoothed(const std::vector<Vec3f>& before, const Mesh& after,
                            const std::vector<uint32_t>& vertices) {
  constexpr uint32_t kOther = UINT32_MAX;
  std::vector<uint32_t> index(before.size(), kOther);
  for (uint32_t i = 0; i < vertices.size(); ++i) index[vertices[i]] = i;
  std::vector<Vec3f> sum(vertices.size(), Vec3f(0));
  std::vector<float> count(vertices.size(), 0);
  for (const Triangle& triangle : after.triangles)
    for (const uint32_t v : triangle) {
      if (index[v] == kOther) continue;
      for (const uint32_t corner : triangle)
        sum[index[v]] += after.positions[corner] - before[corner];
      count[index[v]] += 3;
    }
  for (size_t i = 0; i < sum.size(); ++i) sum[i] /= count[i];
  return sum;
}

}  // namespace

double max_displacement(const Mesh& before, const Mesh& after) {
  return ordered_reduce(
      before.positions.size(), 0.0,
      [&](size_t v) { return distance(after.positions[v], before.positions[v]); },
      [](double a, double b) { return std::max(a, b); });
}

std::vector<uint32_t> flipped_triangles(const std::vector<Vec3f>& before, const Mesh& after) {
  std::vector<uint8_t> is_flipped(after.triangles.size());
  const auto test = [&](size_t face) {
    const Triangle& triangle = after.triangles[face];
    is_flipped[face] =
        area_vector(before, triangle).dot(area_vector(after.positions, triangle)) < 0;
  };
  parallel_for(is_flipped.size(), test, 4096);
  std::vector<uint32_t> flipped;
  for (uint32_t face = 0; face < is_flipped.size(); ++face)
    if (is_flipped[face]) flipped.push_back(face);
  return flipped;
}

std::vector<uint32_t> folded_triangles(const std::vector<Vec3f>& before, const Mesh& after) {
  std::vector<uint32_t> folded = flipped_triangles(before, after);
  if (folded.empty()) return folded;
  const std::vector<Vec3f> normals = vertex_normals(after);
  const auto faces_as_the_surface = [&](uint32_t face) {
    const auto [a, b, c] = after.triangles[face];
    const Vec3d around(normals[a] + normals[b] + normals[c]);
    return area_vector(after.positions, after.triangles[face]).dot(around) > 0;
  };
  folded.erase(std::remove_if(folded.begin(), folded.end(), faces_as_the_surface), folded.end());
  return folded;
}

size_t prevent_folds(const std::vector<Vec3f>& before, Mesh& after, bool along_normals) {
  constexpr int kSmoothings = 30, kHalvings = 5;
  const std::vector<Vec3f> full = after.positions;
  std::vector<uint8_t> halvings(full.size(), 0);
  for (int round = 0;; ++round) {
    const bool smooths = round < kSmoothings, all = smooths && along_normals;
    const std::vector<uint32_t> faces =
        all ? flipped_triangles(before, after) : folded_triangles(before, after);
    if (faces.empty()) break;
    const std::vector<uint32_t> vertices = vertices_of(after, faces);
    const std::vector<Vec3f> smooth = smoothed(before, after, vertices);
    for (size_t i = 0; i < vertices.size(); ++i) {
      const uint32_t v = vertices[i];
      if (!smooths && halvings[v] <= kHalvings) ++halvings[v];
      const float share = halvings[v] > kHalvings ? 0 : std::ldexp(1.0f, -halvings[v]);
      after.positions[v] = before[v] + smooth[i] * share;
    }
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
