// A tree over many lamps: whole branches are weighed at once, so that one lamp of n is chosen in
// log n steps. Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive
// tree splitting" (cite conty2018lights); the bounds of a branch as in Pharr, Jakob, Humphreys
// 2023, "Physically based rendering", section 12.6.3 (cite pharr2023pbr).
#pragma once

#include <vug/render/light.h>
#include <vug/render/vectors.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <vector>

namespace vug::render {

/// Index of a light in a LightSet.
using LightId = uint32_t;
inline constexpr LightId kNoLight = ~0u;

/// The box, a cone of normals and the reach around both; strengths add up.
LightBounds united(const LightBounds& a, const LightBounds& b);

class LightTree {
 public:
  /// A branch, or one light.
  struct alignas(64) Node {
    Box3f box;
    Vec3f axis;
    float cos_spread, sin_spread, cos_reach;
    float strength;
    float radius;     ///< Of the ball around the box.
    uint32_t child;   ///< The first of a pair of branches; of a leaf: its light.
    uint32_t parent;  ///< With kCut: the place in `cut` instead.
  };
  struct Found {
    LightId light = kNoLight;
    float probability = 0;
  };
  /// A light's branch, by its place in `cut`, and the probability with which `descend` finds the
  /// light there.
  struct Place {
    uint32_t branch = 0;
    float probability = 0;
  };

  LightTree() = default;
  /// The same tree for any number of threads. Lights of no strength are left out; `first` is the
  /// id of light 0.
  LightTree(size_t count, LightId first, const std::function<LightBounds(size_t)>& bounds_of);

  size_t size() const { return size_; }  ///< Lights in it.
  bool holds(LightId id) const {
    return id >= first_ && id - first_ < leaves_.size() && leaves_[id - first_] != kNowhere;
  }
  bool is_leaf(uint32_t node) const { return (nodes_[node].parent & kLeaf) != 0; }
  Vec3f centre(uint32_t node) const { return nodes_[node].box.center(); }
  /// The light of a leaf.
  LightId light(uint32_t node) const { return nodes_[node].child; }

  /// A few branches that together hold every light once: single lights, when there are at most
  /// kCutSize.
  const std::vector<uint32_t>& cut() const { return cut_; }

  /// About strength over squared distance, times what cosines are sure; 0 only where no light of
  /// the branch can shine.
  float importance(uint32_t node, const LitPoint& point) const;
  float importance_along(uint32_t node, const Ray& ray, float begin, float end) const;

  /// From a branch down to a light, at each fork by the weights of the two sides; no light where
  /// both weigh nothing.
  template <class Weight>
  Found descend(uint32_t node, double u, const Weight& weight) const {
    Found found;
    double probability = 1;
    bool fresh = false;
    while (!is_leaf(node)) {
      const uint32_t left = nodes_[node].child;
      const auto a = static_cast<double>(weight(left)), b = static_cast<double>(weight(left + 1));
      if (!(a + b > 0)) return found;
      const double part = a / (a + b);
      const bool goes_left = u < part;
      node = goes_left ? left : left + 1;
      u = goes_left ? u / part : (u - part) / (1 - part);
      probability *= goes_left ? part : 1 - part;
      // The number came with 24 bits; deep down, where few are left, the branch scrambles them.
      if (!fresh && probability < 0x1p-10) {
        u = scrambled(u, node);
        fresh = true;
      }
    }
    return {light(node), static_cast<float>(probability)};
  }
  template <class Weight>
  Place place(LightId light, const Weight& weight) const {
    uint32_t node = leaves_[light - first_];
    double probability = 1;
    while (!(nodes_[node].parent & kCut)) {
      const auto own = static_cast<double>(weight(node));
      if (!(own > 0)) return {};
      probability *= own / (own + static_cast<double>(weight(node ^ 1u)));
      node = nodes_[node].parent & ~kLeaf;
    }
    return {nodes_[node].parent & ~(kCut | kLeaf), static_cast<float>(probability)};
  }

  /// Calls visit(light) for each light whose box the ray meets before `end`, and perhaps a few
  /// that it barely misses.
  template <class Visit>
  void each_on(const Ray& ray, float end, const Visit& visit) const {
    if (nodes_.empty()) return;
    const Vec3f inverse(1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z);
    uint32_t stack[64];
    size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const uint32_t node = stack[--height];
      if (!meets(nodes_[node].box, ray.origin, inverse, end)) continue;
      if (is_leaf(node)) {
        visit(light(node));
      } else if (height + 2 <= 64) {
        stack[height++] = nodes_[node].child + 1;
        stack[height++] = nodes_[node].child;
      }
    }
  }

  static constexpr size_t kCutSize = 16;

 private:
  static constexpr uint32_t kNowhere = ~0u, kCut = 1u << 31, kLeaf = 1u << 30;
  struct Item;
  void build(std::vector<Item>& items, size_t begin, size_t end, uint32_t node, uint32_t below,
             int depth);
  void make_cut();

  static double scrambled(double u, uint32_t node) {
    uint64_t bits;
    std::memcpy(&bits, &u, sizeof bits);
    bits = (bits ^ node) * 0x9e3779b97f4a7c15u;  // splitmix64: Steele, Lea, Flood 2014
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
  }
  static bool meets(const Box3f& box, const Vec3f& origin, const Vec3f& inverse, float end) {
    float from = 0, to = end;
    for (int i = 0; i < 3; ++i) {
      const float a = (box.min[i] - origin[i]) * inverse[i];
      const float b = (box.max[i] - origin[i]) * inverse[i];
      // A ray inside a face gives 0 * infinity, which these leave out.
      from = std::max(from, std::min(a, b) * 0.999999f);
      to = std::min(to, std::max(a, b) * 1.000001f);
    }
    return from <= to;
  }

  LightId first_ = 0;
  size_t size_ = 0;
  std::vector<Node> nodes_;  ///< Pairs at 2i and 2i + 1; the root is 0, and 1 is not used.
  std::vector<uint32_t> leaves_, cut_;
};

}  // namespace vug::render
