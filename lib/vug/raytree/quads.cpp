// SPDX-License-Identifier: Apache-2.0
#include <vug/raytree/quads.h>
#include <vug/raytree/ray.h>

#include <algorithm>

namespace vug::raytree {
namespace {

/// The directed edges of all triangles, grouped by the lesser of their two vertices. An edge is
/// stored as 3 * triangle + the corner at which it starts.
class Edges {
 public:
  explicit Edges(const mesh::Mesh& mesh)
      : begin_(mesh.positions.size() + 1, 0), edges_(3 * mesh.triangles.size()) {
    const auto min_vertex = [](const mesh::Triangle& t, size_t e) {
      return std::min(t[e], t[(e + 1) % 3]);
    };
    for (const mesh::Triangle& t : mesh.triangles)
      for (size_t e = 0; e < 3; ++e) ++begin_[min_vertex(t, e) + 1];
    for (size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    std::vector<size_t> next(begin_.begin(), begin_.end() - 1);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
      for (size_t e = 0; e < 3; ++e) edges_[next[min_vertex(mesh.triangles[i], e)]++] = 3 * i + e;
  }
  /// Begin and end of the edges whose lesser vertex this is.
  std::pair<const size_t*, const size_t*> at(uint32_t vertex) const {
    return {edges_.data() + begin_[vertex], edges_.data() + begin_[vertex + 1]};
  }

 private:
  std::vector<size_t> begin_, edges_;
};

}  // namespace

std::vector<Quad> pair_triangles(const mesh::Mesh& mesh) {
  constexpr size_t kNone = ~size_t{0};
  const Edges edges(mesh);
  std::vector<bool> taken(mesh.triangles.size(), false);
  std::vector<Quad> quads;
  quads.reserve(mesh.triangles.size() / 2 + mesh.triangles.size() / 32 + 1);
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (taken[i]) continue;
    taken[i] = true;
    const mesh::Triangle& own = mesh.triangles[i];
    size_t side = 0, partner = kNone;
    float longest = -1;
    for (size_t e = 0; e < 3; ++e) {
      const uint32_t from = own[e], to = own[(e + 1) % 3];
      const float size = length(mesh.positions[to] - mesh.positions[from]);
      if (!(size > longest)) continue;
      const auto [first, last] = edges.at(std::min(from, to));
      const size_t* const found = std::find_if(first, last, [&](size_t edge) {
        const mesh::Triangle& other = mesh.triangles[edge / 3];
        return !taken[edge / 3] && other[edge % 3] == to && other[(edge + 1) % 3] == from;
      });
      if (found != last) side = e, partner = *found, longest = size;
    }
    const auto number = static_cast<uint32_t>(i);
    if (partner == kNone) {
      quads.push_back({{own[0], own[1], own[2], own[2]}, {{{number, 0}, {}}}});
      continue;
    }
    const size_t other = partner / 3;
    taken[other] = true;
    const auto turn = static_cast<uint32_t>((side + 2) % 3);
    const auto other_turn = static_cast<uint32_t>((partner + 2) % 3);
    quads.push_back({{own[turn], own[side], mesh.triangles[other][other_turn], own[(side + 1) % 3]},
                     {{{number, turn}, {static_cast<uint32_t>(other), other_turn}}}});
  }
  return quads;
}

}  // namespace vug::raytree
