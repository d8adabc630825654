// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/clip.h>
#include <vug/mesh/split_edge.h>

#include <algorithm>
#include <array>
#include <unordered_map>

namespace vug::mesh {
namespace {

constexpr uint32_t kNone = ~0u;

class Cutter {
 public:
  Cutter(const Mesh& mesh, const std::vector<float>& values, float level)
      : mesh_(mesh), values_(values), level_(level), kept_(mesh.positions.size(), kNone) {
    for (const Attribute& attribute : mesh.attributes)
      out_.attributes.push_back({attribute.name, attribute.arity, {}});
  }

  Mesh run() && {
    std::vector<uint8_t> used(mesh_.positions.size(), 0);
    for (const Triangle& t : mesh_.triangles) note(t, used);
    for (uint32_t v = 0; v < used.size(); ++v)
      if (used[v]) kept_[v] = add(v, v, 0);
    for (const Triangle& t : mesh_.triangles) cut(t);
    return std::move(out_);
  }

 private:
  bool stays(uint32_t v) const { return values_[v] <= level_; }

  /// The position of the crossing on the edge, as a fraction of the way from the inside end.
  float share(uint32_t inside, uint32_t outside) const {
    const float at = (level_ - values_[inside]) / (values_[outside] - values_[inside]);
    return at < 1e-3F ? 0 : at;
  }

  /// Marks the vertices used by the remaining part of the triangle.
  void note(const Triangle& t, std::vector<uint8_t>& used) const {
    if (corners(t, [&](uint32_t in, uint32_t out) {
          return share(in, out) > 0 ? kNone : in;
        }).size() < 3)
      return;
    for (const uint32_t v : t)
      if (stays(v)) used[v] = 1;
  }

  /// The corners of the remaining part of the triangle in order, each once; `crossing` returns the
  /// vertex on the edge between an inside and an outside corner.
  template <class Crossing>
  std::vector<uint32_t> corners(const Triangle& t, const Crossing& crossing) const {
    std::vector<uint32_t> ring;
    const auto push = [&](uint32_t v) {
      if (v == kNone || std::find(ring.begin(), ring.end(), v) == ring.end()) ring.push_back(v);
    };
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      if (stays(a)) push(a);
      if (stays(a) != stays(b)) push(stays(a) ? crossing(a, b) : crossing(b, a));
    }
    return ring;
  }

  void cut(const Triangle& t) {
    const uint32_t old = static_cast<uint32_t>(mesh_.positions.size());
    // New vertices have numbers after those of the old mesh, so all are distinct.
    std::vector<uint32_t> ring = corners(t, [&](uint32_t in, uint32_t out) {
      return share(in, out) > 0 ? old + crossing(in, out) : in;
    });
    if (ring.size() < 3) return;
    for (uint32_t& v : ring) v = v < old ? kept_[v] : v - old;
    if (ring.size() == 3) {
      out_.triangles.push_back({ring[0], ring[1], ring[2]});
      return;
    }
    const auto length2 = [&](size_t a, size_t b) {
      return (out_.positions[ring[a]] - out_.positions[ring[b]]).length2();
    };
    const size_t first = length2(0, 2) <= length2(1, 3) ? 0 : 1;
    for (const size_t k : {size_t{1}, size_t{2}})
      out_.triangles.push_back({ring[first], ring[first + k], ring[(first + k + 1) % 4]});
  }

  /// The new vertex on an edge, created on first use.
  uint32_t crossing(uint32_t inside, uint32_t outside) {
    const uint64_t key = uint64_t{inside} << 32 | outside;
    const auto [at, is_new] = crossings_.try_emplace(key, 0);
    if (is_new) at->second = add(inside, outside, share(inside, outside));
    return at->second;
  }

  /// Adds a vertex between a and b.
  uint32_t add(uint32_t a, uint32_t b, float share) {
    const auto between = [share](const auto& x, const auto& y) { return x + (y - x) * share; };
    return split_edge(mesh_, a, b, between, out_);
  }

  const Mesh& mesh_;
  const std::vector<float>& values_;
  float level_;
  std::vector<uint32_t> kept_;
  std::unordered_map<uint64_t, uint32_t> crossings_;
  Mesh out_;
};

}  // namespace

Mesh clip(const Mesh& mesh, const std::vector<float>& values, float level) {
  if (values.size() != mesh.positions.size())
    throw Error(ErrorCode::internal, "clip needs one value per vertex");
  return Cutter(mesh, values, level).run();
}

}  // namespace vug::mesh
