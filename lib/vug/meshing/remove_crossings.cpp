// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/self_intersections.h>
#include <vug/meshing/remove_crossings.h>
#include <vug/meshing/split_quads.h>

#include <algorithm>

namespace vug::meshing {
namespace {

constexpr double kShares[] = {1, 0.5, 0.25,
                              0};  ///< Shares of the move that remain, one after the other.
constexpr uint8_t kRaw = 3;        ///< The index of the last.

void sort_unique(std::vector<uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

class Retreat {
 public:
  Retreat(const FaceMesh& raw, MoveResult& moved, mesh::Mesh& mesh)
      : raw_(raw), moved_(moved), mesh_(mesh), full_(moved.points), level_(full_.size()) {
    first_triangle_.reserve(raw.faces.size() + 1);
    for (const Face& face : raw.faces) {
      first_triangle_.push_back(static_cast<uint32_t>(face_of_.size()));
      face_of_.insert(face_of_.end(), face.size - 2,
                      static_cast<uint32_t>(first_triangle_.size() - 1));
    }
    first_triangle_.push_back(static_cast<uint32_t>(face_of_.size()));
  }

  void run() {
    std::vector<uint32_t> bad = without_area(all_triangles());
    add(mesh::self_intersections(mesh_), bad);
    if (bad.empty()) return;
    const mesh::BoxTree tree(boxes());
    while (!bad.empty()) {
      const std::vector<uint32_t> changed = shorten(bad);
      if (changed.empty()) return;
      bad = without_area(changed);
      add(mesh::self_intersections_of(changed, mesh_, tree), bad);
    }
  }

 private:
  std::vector<uint32_t> all_triangles() const {
    std::vector<uint32_t> all(face_of_.size());
    for (uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    return all;
  }

  std::vector<uint32_t> without_area(const std::vector<uint32_t>& triangles) const {
    std::vector<uint32_t> list;
    for (const uint32_t t : triangles)
      if (mesh::double_area_vector(mesh_, t) == Vec3d(0)) list.push_back(t);
    return list;
  }

  static void add(const std::vector<mesh::FacePair>& pairs, std::vector<uint32_t>& triangles) {
    for (const auto& [low, high] : pairs) triangles.insert(triangles.end(), {low, high});
    sort_unique(triangles);
  }

  /// For each triangle, a box that contains its polygon with any share of the moves.
  std::vector<Box3d> boxes() const {
    std::vector<Box3d> all(face_of_.size());
    for (size_t t = 0; t < all.size(); ++t) {
      const Face& face = raw_.faces[face_of_[t]];
      for (uint32_t k = 0; k < face.size; ++k)
        for (const Vec3d& p : {raw_.points[face.corners[k]], full_[face.corners[k]]})
          all[t].extendBy(Vec3d(Vec3f(p)));
    }
    return all;
  }

  /// Shortens the moves of the vertices of these triangles, and returns the triangles that change.
  std::vector<uint32_t> shorten(const std::vector<uint32_t>& triangles) {
    std::vector<uint32_t> vertices;
    for (const uint32_t t : triangles) {
      const Face& face = raw_.faces[face_of_[t]];
      for (uint32_t k = 0; k < face.size; ++k)
        if (level_[face.corners[k]] < kRaw) vertices.push_back(face.corners[k]);
    }
    sort_unique(vertices);
    std::vector<uint32_t> changed;
    for (const uint32_t v : vertices) {
      if (level_[v] == 0) ++moved_.shortened_moves;
      const double share = kShares[++level_[v]];
      moved_.points[v] = raw_.points[v] + (full_[v] - raw_.points[v]) * share;
      moved_.on_crease[v] = 0;
      mesh_.positions[v] = Vec3f(moved_.points[v]);
      for (uint32_t i = raw_.first[v]; i < raw_.first[v + 1]; ++i) {
        const uint32_t f = raw_.around[i];
        for (uint32_t t = first_triangle_[f]; t < first_triangle_[f + 1]; ++t) changed.push_back(t);
      }
    }
    sort_unique(changed);
    for (const uint32_t t : changed) split_raw(face_of_[t]);
    return changed;
  }

  /// Splits a quad along the shorter diagonal if all its vertices are at their raw positions.
  void split_raw(uint32_t f) {
    const Face& face = raw_.faces[f];
    for (uint32_t k = 0; k < face.size; ++k)
      if (level_[face.corners[k]] < kRaw) return;
    if (face.size != 4) return;
    const auto [a, b] = halves(face, shorter_from_0(face, raw_.points));
    mesh_.triangles[first_triangle_[f]] = a;
    mesh_.triangles[first_triangle_[f] + 1] = b;
  }

  const FaceMesh& raw_;
  MoveResult& moved_;
  mesh::Mesh& mesh_;
  const std::vector<Vec3d> full_;  ///< The positions after the whole moves.
  std::vector<uint8_t> level_;     ///< Index of the share of each vertex.
  std::vector<uint32_t> first_triangle_, face_of_;
};

}  // namespace

void remove_crossings(const FaceMesh& raw, MoveResult& moved, mesh::Mesh& mesh) {
  Retreat(raw, moved, mesh).run();
}

}  // namespace vug::meshing
