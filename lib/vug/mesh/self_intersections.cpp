// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/flat_fans.h>
#include <vug/mesh/self_intersections.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <numeric>

namespace vug::mesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Facet = Kernel::Triangle_3;

Box3d box_of(const Mesh& mesh, size_t face) {
  Box3d box;
  for (const Vec3d& p : corners(mesh, face)) box.extendBy(p);
  return box;
}

class Tester {
 public:
  /// `flat`: for each vertex, whether its triangles do not intersect each other; empty: unknown.
  Tester(const Mesh& mesh, const std::vector<char>& flat) : mesh_(mesh), flat_(flat) {}

  Point point(uint32_t vertex) const {
    const Vec3f& p = mesh_.positions[vertex];
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  }
  Facet facet(uint32_t face) const {
    const Triangle& t = mesh_.triangles[face];
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  bool meet(uint32_t a, uint32_t b) const {
    const Triangle& s = mesh_.triangles[a];
    const Triangle& t = mesh_.triangles[b];
    int shared = 0;
    size_t at_s = 0;  // With one shared corner: that corner; with two: the opposite corner.
    size_t at_t = 0;
    bool in_s[3] = {};
    bool in_t[3] = {};
    for (size_t i = 0; i < 3; ++i)
      for (size_t j = 0; j < 3; ++j)
        if (s[i] == t[j]) {
          if (!flat_.empty() && flat_[s[i]]) return false;
          ++shared;
          in_s[i] = in_t[j] = true;
        }
    if (shared >= 3) return true;
    if (shared == 0) return CGAL::do_intersect(facet(a), facet(b));
    const bool wanted = shared == 1;
    for (size_t i = 0; i < 3; ++i) {
      if (in_s[i] == wanted) at_s = i;
      if (in_t[i] == wanted) at_t = i;
    }
    if (shared == 2) {
      // Across a common edge they intersect only if folded flat onto each other.
      const Point p = point(s[(at_s + 1) % 3]);
      const Point q = point(s[(at_s + 2) % 3]);
      return CGAL::coplanar(p, q, point(s[at_s]), point(t[at_t])) &&
             CGAL::coplanar_orientation(p, q, point(s[at_s]), point(t[at_t])) == CGAL::POSITIVE;
    }
    const Segment far_s(point(s[(at_s + 1) % 3]), point(s[(at_s + 2) % 3]));
    const Segment far_t(point(t[(at_t + 1) % 3]), point(t[(at_t + 2) % 3]));
    return CGAL::do_intersect(far_s, facet(b)) || CGAL::do_intersect(far_t, facet(a));
  }

 private:
  const Mesh& mesh_;
  const std::vector<char>& flat_;
};

/// The pairs of each of the faces with those faces of the tree that `wanted` accepts as the second.
template <class Wanted>
std::vector<FacePair> find_pairs(const std::vector<uint32_t>& faces, const Mesh& mesh,
                                 const BoxTree& tree, const std::vector<char>& flat,
                                 const Wanted& wanted) {
  const Tester tester(mesh, flat);
  constexpr size_t kChunk = 1024;
  std::vector<std::vector<FacePair>> found((faces.size() + kChunk - 1) / kChunk);
  parallel_for(found.size(), [&](size_t chunk) {
    const size_t end = std::min(faces.size(), (chunk + 1) * kChunk);
    for (size_t i = chunk * kChunk; i < end; ++i) {
      const uint32_t face = faces[i];
      if (tester.facet(face).is_degenerate()) continue;
      tree.visit_overlapping(box_of(mesh, face), [&](uint32_t other) {
        if (wanted(face, other) && box_of(mesh, face).intersects(box_of(mesh, other)) &&
            !tester.facet(other).is_degenerate() && tester.meet(face, other))
          found[chunk].emplace_back(std::minmax(face, other));
      });
    }
  });
  std::vector<FacePair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<uint32_t> all_faces(const Mesh& mesh) {
  std::vector<uint32_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), 0U);
  return faces;
}

}  // namespace

std::vector<Box3d> triangle_boxes(const Mesh& mesh) {
  std::vector<Box3d> boxes(mesh.triangles.size());
  parallel_for(
      boxes.size(), [&](size_t face) { boxes[face] = box_of(mesh, face); }, 1024);
  return boxes;
}

std::vector<FacePair> self_intersections(const Mesh& mesh) {
  return find_pairs(all_faces(mesh), mesh, BoxTree(triangle_boxes(mesh)), flat_fans(mesh),
                    [](uint32_t face, uint32_t other) { return face < other; });
}

std::vector<FacePair> self_intersections(const Mesh& mesh,
                                         const std::vector<uint32_t>& component_of) {
  return find_pairs(all_faces(mesh), mesh, BoxTree(triangle_boxes(mesh)), flat_fans(mesh),
                    [&](uint32_t face, uint32_t other) {
                      return face < other && component_of[face] == component_of[other];
                    });
}

std::vector<FacePair> self_intersections_of(const std::vector<uint32_t>& faces, const Mesh& mesh,
                                            const BoxTree& tree) {
  const auto listed = [&](uint32_t face) {
    return std::binary_search(faces.begin(), faces.end(), face);
  };
  // Pairs of two listed faces are found at the lower one.
  return find_pairs(faces, mesh, tree, {}, [&](uint32_t face, uint32_t other) {
    return face != other && (face < other || !listed(other));
  });
}

}  // namespace vug::mesh
