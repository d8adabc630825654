// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cancellable_scope.h>
#include <vug/mesh/folds.h>
#include <vug/mesh/retreat.h>
#include <vug/mesh/self_intersections.h>
#include <vug/mesh/sort_unique.h>

#include <algorithm>
#include <numeric>

namespace vug::mesh {
namespace {

using Triangles = std::vector<uint32_t>;  ///< Ascending indices.

constexpr float kShares[] = {1, 0.5F, 0.25F, 0.125F, 0};
constexpr uint8_t kNothing = 4;  ///< The index of the last share.

class Retreat {
 public:
  Retreat(const std::vector<Vec3f>& before, Mesh& mesh, const PolygonGroups& groups)
      : before_(before),
        mesh_(mesh),
        groups_(groups),
        full_(mesh.positions),
        fans_(mesh),
        level_(full_.size()),
        polygon_of_(mesh.triangles.size()) {
    std::iota(polygon_of_.begin(), polygon_of_.end(), 0U);
    for (uint32_t p = 0; p + 1 < groups.first.size(); ++p)
      std::fill(polygon_of_.begin() + groups.first[p], polygon_of_.begin() + groups.first[p + 1],
                p);
  }

  std::vector<float> run(Triangles invalid) {
    const BoxTree tree(boxes());
    while (!invalid.empty()) {
      check_cancelled();
      const Triangles changed = shorten(invalid);
      if (changed.empty()) break;
      invalid = invalid_among(changed, self_intersections_of(changed, mesh_, tree));
    }
    std::vector<float> shares(level_.size());
    for (size_t v = 0; v < shares.size(); ++v) shares[v] = kShares[level_[v]];
    return shares;
  }

 private:
  /// For each triangle, a box that contains its polygon with any share of the moves.
  std::vector<Box3d> boxes() const {
    std::vector<Box3d> all(mesh_.triangles.size());
    for (uint32_t t = 0; t < all.size(); ++t)
      for_each_corner(polygon_of_[t], [&](uint32_t v) {
        all[t].extendBy(Vec3d(before_[v])), all[t].extendBy(Vec3d(full_[v]));
      });
    return all;
  }

  template <class Visit>
  void for_each_triangle(uint32_t polygon, const Visit& visit) const {
    if (groups_.first.empty()) return visit(polygon);
    for (uint32_t t = groups_.first[polygon]; t < groups_.first[polygon + 1]; ++t) visit(t);
  }
  template <class Visit>
  void for_each_corner(uint32_t polygon, const Visit& visit) const {
    for_each_triangle(polygon, [&](uint32_t t) {
      for (const uint32_t v : mesh_.triangles[t]) visit(v);
    });
  }

  Triangles invalid_among(const Triangles& triangles, const std::vector<FacePair>& pairs) const {
    Triangles list;
    for (const uint32_t t : triangles)
      if (double_area_vector(mesh_, t) == Vec3d(0) || is_folded(mesh_, fans_, t)) list.push_back(t);
    for (const auto& [low, high] : pairs) list.insert(list.end(), {low, high});
    sort_unique(list);
    return list;
  }

  /// Shortens the moves of the vertices of these triangles; returns the triangles that change.
  Triangles shorten(const Triangles& triangles) {
    std::vector<uint32_t> vertices;
    for (const uint32_t t : triangles)
      for_each_corner(polygon_of_[t], [&](uint32_t v) {
        if (level_[v] < kNothing && full_[v] != before_[v]) vertices.push_back(v);
      });
    sort_unique(vertices);
    std::vector<uint32_t> polygons;
    for (const uint32_t v : vertices) {
      const double share = static_cast<double>(kShares[++level_[v]]);
      const Vec3d from(before_[v]);
      mesh_.positions[v] = Vec3f(from + (Vec3d(full_[v]) - from) * share);
      for (const uint32_t t : fans_.at(v)) polygons.push_back(polygon_of_[t]);
    }
    sort_unique(polygons);
    Triangles changed;
    for (const uint32_t p : polygons)
      for_each_triangle(p, [&](uint32_t t) { changed.push_back(t); });
    if (!groups_.divide) return changed;
    bool divided = false;
    for (const uint32_t p : polygons) divided = groups_.divide(p) || divided;
    if (divided) fans_ = Fans(mesh_);
    return changed;
  }

  const std::vector<Vec3f>& before_;
  Mesh& mesh_;
  const PolygonGroups& groups_;
  const std::vector<Vec3f> full_;  ///< The positions after the whole moves.
  Fans fans_;
  std::vector<uint8_t> level_;  ///< Index of the share of each vertex.
  std::vector<uint32_t> polygon_of_;
};

}  // namespace

std::vector<float> retreat(const std::vector<Vec3f>& before, Mesh& mesh,
                           const PolygonGroups& groups) {
  return retreat(before, mesh, self_intersections(mesh), groups);
}

std::vector<float> retreat(const std::vector<Vec3f>& before, Mesh& mesh,
                           const std::vector<FacePair>& crossings, const PolygonGroups& groups) {
  Triangles invalid = folded_triangles(mesh);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (double_area_vector(mesh, t) == Vec3d(0)) invalid.push_back(t);
  for (const auto& [low, high] : crossings) invalid.insert(invalid.end(), {low, high});
  sort_unique(invalid);
  if (invalid.empty()) return std::vector<float>(mesh.positions.size(), 1);
  return Retreat(before, mesh, groups).run(std::move(invalid));
}

}  // namespace vug::mesh
