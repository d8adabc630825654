// SPDX-License-Identifier: Apache-2.0
// Light BVH: whole branches are weighted at once, so one of n lights is chosen in O(log n) steps.
// Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive tree splitting"
// (cite conty2018lights); branch bounds as in Pharr, Jakob, Humphreys 2023, "Physically based
// rendering", section 12.6.3 (cite pharr2023pbr). Nodes have eight children, which are weighted
// with SIMD.
#pragma once

#include <vug/render/light.h>
#include <vug/render/vectors.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <vector>

namespace vug::render {

/// Index of a light in a LightSet.
using LightId = uint32_t;
inline constexpr LightId kNoLight = ~0u;

/// The union of both boxes, normal cones and emission angles; strengths are added.
LightBounds union_of(const LightBounds& a, const LightBounds& b);

class LightTree {
 public:
  static constexpr size_t kWidth = 8;
  static constexpr uint32_t kLeaf = 1u << 31;
  /// A node of eight children, branches or lights, stored as structure of arrays so that they are
  /// weighted together. Unused lanes have strength 0.
  struct alignas(64) Node {
    std::array<float, kWidth> x{}, y{}, z{}, radius{};  ///< Bounding sphere of the box.
    std::array<float, kWidth> axis_x{}, axis_y{}, axis_z{};
    std::array<float, kWidth> cos_spread{}, sin_spread{}, cos_reach{};
    std::array<float, kWidth> strength{};
    std::array<uint32_t, kWidth> child{};  ///< Index of another node, or kLeaf and a light.

    Node() { child.fill(kLeaf); }
    /// All children are lights.
    bool has_only_leaves() const {
      uint32_t all = kLeaf;
      for (const uint32_t c : child) all &= c;
      return all != 0;
    }
    bool is_leaf(size_t lane) const { return strength[lane] > 0 && (child[lane] & kLeaf) != 0; }
    /// The light of a leaf.
    LightId light(size_t lane) const { return child[lane] & ~kLeaf; }
    Vec3f center(size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  };
  using Weights = std::array<float, kWidth>;
  struct SampledLeaf {
    LightId light = kNoLight;
    float probability = 0;
  };
  /// The branch of a light, and the probability with which `descend` reaches the light from there.
  struct Location {
    uint32_t branch = 0;
    float probability = 0;
  };

  LightTree() = default;
  /// Builds the same tree for any number of threads. Lights of strength 0 are left out; `first` is
  /// the id of light 0.
  LightTree(size_t count, LightId first, const std::function<LightBounds(size_t)>& bounds_of);

  size_t size() const { return size_; }  ///< Number of lights in the tree.
  bool contains(LightId id) const {
    return id >= first_ && id - first_ < leaves_.size() && leaves_[id - first_] != kNoNode;
  }

  /// The top of the tree: a few branches that together hold every light once. With at most
  /// kMaxBranches lights they are single lights. Branch i is lane i % kWidth of node i / kWidth.
  size_t branches() const { return branches_; }
  const Node& node(size_t index) const { return nodes_[index]; }

  /// Approximately strength over squared distance, times conservative cosines; 0 only where no
  /// light of a branch can contribute.
  static Weights importance(const Node& node, const LightSampleContext& point);
  static Weights importance_along(const Node& node, const Ray& ray, float begin, float end);

  /// Descends from a branch to a light; each node is weighted by `weigh`, which returns 8 floats.
  /// Returns kNoLight if all weights are 0.
  template <class Weigh>
  SampledLeaf descend(size_t branch, double u, const Weigh& weigh) const {
    uint32_t child = nodes_[branch / kWidth].child[branch % kWidth];
    float probability = 1;
    bool fresh = false;
    while (!(child & kLeaf)) {
      const Node& node = nodes_[child];
      const Weights weights = weigh(node);
      const float all = sum(weights);
      if (!(all > 0)) return {};
      const float target = static_cast<float>(u) * all;
      float passed = 0;
      size_t lane = 0;
      for (size_t i = 0; i < kWidth; ++i) {
        if (!(weights[i] > 0)) continue;
        lane = i;
        if (target < passed + weights[i]) break;
        passed += weights[i];
      }
      u = (u * static_cast<double>(all) - static_cast<double>(passed)) /
          static_cast<double>(weights[lane]);
      u = std::clamp(u, 0.0, 0x1.fffffffffffffp-1);
      probability *= weights[lane] / all;
      // The random number has 24 bits; deep in the tree, where few are left, the node index
      // scrambles them.
      if (!fresh && probability < 0x1p-10f) {
        u = scrambled(u, child);
        fresh = true;
      }
      child = node.child[lane];
    }
    return {child & ~kLeaf, probability};
  }
  template <class Weigh>
  Location locate(LightId light, const Weigh& weigh) const {
    uint32_t at = leaves_[light - first_];
    float probability = 1;
    for (; at >= branches_; at = parents_[at / kWidth]) {
      const Weights weights = weigh(nodes_[at / kWidth]);
      if (!(weights[at % kWidth] > 0)) return {};
      probability *= weights[at % kWidth] / sum(weights);
    }
    return {at, probability};
  }

  /// Calls visit(light) for each light whose bounding sphere the ray hits before `end`, and
  /// possibly for a few near misses.
  template <class Visit>
  void for_each_hit(const Ray& ray, float end, const Visit& visit) const {
    for (size_t top = 0; top * kWidth < branches_; ++top)
      for_each_hit(nodes_[top], ray, end, visit);
  }

  static constexpr size_t kMaxBranches = 16;

 private:
  static constexpr uint32_t kNoNode = ~0u;
  struct Item;
  struct BuildNode;
  class Builder;
  void flatten(const std::vector<BuildNode>& build_nodes);

  static float sum(const Weights& weights) {
    float all = 0;
    for (const float weight : weights) all += weight;
    return all;
  }
  static double scrambled(double u, uint32_t node) {
    uint64_t bits;
    std::memcpy(&bits, &u, sizeof bits);
    bits = (bits ^ node) * 0x9e3779b97f4a7c15u;  // splitmix64: Steele, Lea, Flood 2014
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
  }
  template <class Visit>
  void for_each_hit(const Node& node, const Ray& ray, float end, const Visit& visit) const {
    const std::array<bool, kWidth> met = hit_lanes(node, ray, end);
    for (size_t lane = 0; lane < kWidth; ++lane) {
      if (!met[lane]) continue;
      if (node.child[lane] & kLeaf)
        visit(node.light(lane));
      else
        for_each_hit(nodes_[node.child[lane]], ray, end, visit);
    }
  }
  static std::array<bool, kWidth> hit_lanes(const Node& node, const Ray& ray, float end);

  LightId first_ = 0;
  size_t size_ = 0, branches_ = 0;
  std::vector<Node> nodes_;        ///< The branches' nodes come first.
  std::vector<uint32_t> parents_;  ///< For each other node: its parent times eight, plus the lane.
  std::vector<uint32_t> leaves_;   ///< For each light: its node times eight, plus the lane.
};

}  // namespace vug::render
