// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/box_tree.h>
#include <vug/metrics/self_intersections.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace vug::metrics {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Segment = Kernel::Segment_3;
using Facet = Kernel::Triangle_3;

class Tester {
 public:
  explicit Tester(const mesh::Mesh& mesh) : mesh_(mesh) {}

  Point point(uint32_t vertex) const {
    const Vec3f& p = mesh_.positions[vertex];
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
  }
  Facet facet(uint32_t face) const {
    const mesh::Triangle& t = mesh_.triangles[face];
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  bool meet(uint32_t a, uint32_t b) const {
    const mesh::Triangle& s = mesh_.triangles[a];
    const mesh::Triangle& t = mesh_.triangles[b];
    int shared = 0;
    size_t at_s = 0;  // With one shared corner: that corner; with two: the opposite corner.
    size_t at_t = 0;
    bool in_s[3] = {};
    bool in_t[3] = {};
    for (size_t i = 0; i < 3; ++i)
      for (size_t j = 0; j < 3; ++j)
        if (s[i] == t[j]) {
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
  const mesh::Mesh& mesh_;
};

}  // namespace

std::vector<std::pair<uint32_t, uint32_t>> self_intersections(const mesh::Mesh& mesh) {
  const size_t count = mesh.triangles.size();
  const Tester tester(mesh);
  std::vector<Box3d> boxes(count);
  std::vector<char> flat(count);
  parallel_for(
      count,
      [&](size_t face) {
        for (const Vec3d& p : mesh::corners(mesh, face)) boxes[face].extendBy(p);
        flat[face] = tester.facet(static_cast<uint32_t>(face)).is_degenerate();
      },
      1024);
  const mesh::BoxTree tree(boxes);
  constexpr size_t kChunk = 1024;
  std::vector<std::vector<std::pair<uint32_t, uint32_t>>> found((count + kChunk - 1) / kChunk);
  parallel_for(found.size(), [&](size_t chunk) {
    const size_t end = std::min(count, (chunk + 1) * kChunk);
    for (size_t face = chunk * kChunk; face < end; ++face) {
      if (flat[face]) continue;
      const auto low = static_cast<uint32_t>(face);
      const size_t before = found[chunk].size();
      tree.visit_overlapping(boxes[face], [&](uint32_t high) {
        if (high > low && !flat[high] && tester.meet(low, high))
          found[chunk].emplace_back(low, high);
      });
      std::sort(found[chunk].begin() + static_cast<int64_t>(before), found[chunk].end());
    }
  });
  std::vector<std::pair<uint32_t, uint32_t>> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace vug::metrics
