// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/refine.h>
#include <vug/mesh/split_edge.h>
#include <vug/mesh/split_triangle.h>

#include <fmt/format.h>

#include <array>
#include <unordered_map>

namespace vug::mesh {
namespace {

class Refiner {
 public:
  Refiner(Mesh& mesh, double longest) : mesh_(mesh), limit2_(longest * longest) {}

  /// Halves long edges once; returns whether there were any.
  bool halve() {
    middles_.clear();
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh_.triangles) {
      const std::array<uint32_t, 3> m = {middle(t[0], t[1]), middle(t[1], t[2]),
                                         middle(t[2], t[0])};
      split_triangle(
          t, m, [&](uint32_t a, uint32_t b) { return length2(a, b); }, finer);
    }
    mesh_.triangles = std::move(finer);
    return !middles_.empty();
  }

 private:
  double length2(uint32_t a, uint32_t b) const {
    return (Vec3d(mesh_.positions[a]) - Vec3d(mesh_.positions[b])).length2();
  }

  /// The vertex in the middle of an edge that is too long, otherwise kNotSplit.
  uint32_t middle(uint32_t a, uint32_t b) {
    if (!(length2(a, b) > limit2_)) return kNotSplit;
    const uint64_t key = uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [at, fresh] = middles_.try_emplace(key, kNotSplit);
    const auto half = [](const auto& x, const auto& y) { return (x + y) * 0.5f; };
    if (fresh) at->second = split_edge(mesh_, a, b, half, mesh_);
    return at->second;
  }

  Mesh& mesh_;
  double limit2_;
  std::unordered_map<uint64_t, uint32_t> middles_;
};

}  // namespace

Mesh refined(Mesh mesh, double longest, size_t most) {
  if (!(longest > 0)) throw Error(ErrorCode::bad_input, "the edge length must be positive");
  Refiner refiner(mesh, longest);
  while (refiner.halve())
    if (mesh.triangles.size() > most)
      throw Error(ErrorCode::too_large,
                  fmt::format("edges of {:.3g} m give more than {} triangles", longest, most));
  return mesh;
}

}  // namespace vug::mesh
