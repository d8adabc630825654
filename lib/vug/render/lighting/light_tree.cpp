// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/render/lighting/light_tree.h>

#include <array>
#include <cmath>

namespace vug::render {
namespace {

constexpr size_t kBins = 12;
/// Larger branches are built in parallel, and their splits are evaluated with about this many of
/// their lights.
constexpr size_t kLarge = 65536;
/// Deeper branches are split in halves, so that traversals need only a small stack.
constexpr int kMaxDepth = 44;

float safe_root(float x) { return std::sqrt(std::max(0.0f, x)); }

Vec3f any_perpendicular(const Vec3f& v) { return Frame(v).x; }

/// Orientation measure of the surface area orientation heuristic: the integral of the cosine beyond
/// the emission angle over the normal cone (Conty Estevez and Kulla 2018, equation 1).
double direction_measure(const LightBounds& b) {
  const double cosine = std::clamp(static_cast<double>(b.cos_spread), -1.0, 1.0);
  const double spread = maths::acos(cosine), sine = std::sqrt(1 - cosine * cosine);
  const double reach = maths::acos(std::clamp(static_cast<double>(b.cos_reach), -1.0, 1.0));
  const double wide = std::min(spread + reach, kPi);
  return 2 * kPi * (1 - cosine) +
         kPi / 2 * (2 * wide * sine - maths::cos(spread - 2 * wide) - 2 * spread * sine + cosine);
}

double surface(const Box3f& box) {
  const Vec3d d(box.size());
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

double cost(const LightBounds& b) {
  return static_cast<double>(b.strength) * direction_measure(b) * surface(b.box);
}

}  // namespace

/// Computes the cones with cosines and sines only. A union wider than half a turn becomes all
/// directions, which loses nothing: such a branch says nothing about directions.
LightBounds union_of(const LightBounds& a, const LightBounds& b) {
  if (!(b.strength > 0)) return a;
  if (!(a.strength > 0)) return b;
  const LightBounds& wide = a.cos_spread <= b.cos_spread ? a : b;
  const LightBounds& narrow = a.cos_spread <= b.cos_spread ? b : a;
  LightBounds out = wide;
  out.box.extendBy(narrow.box);
  out.cos_reach = std::min(a.cos_reach, b.cos_reach);
  out.strength = a.strength + b.strength;
  const float cw = wide.cos_spread, sw = safe_root(1 - cw * cw);
  const float cn = narrow.cos_spread, sn = safe_root(1 - cn * cn);
  const float apart = std::clamp(dot(wide.axis, narrow.axis), -1.0f, 1.0f);
  if (cw <= -1 || apart >= cw * cn + sw * sn) return out;  // the wide cone contains the other
  const float c1 = cw * cn - sw * sn, s1 = sw * cn + cw * sn;
  if (cw + cn <= 0 || c1 + apart <= 0) {
    out.cos_spread = -1;
    return out;
  }
  // Half the sum of both spreads and the angle between them.
  const float sum = c1 * apart - s1 * safe_root(1 - apart * apart);
  const float half_cos = safe_root(0.5f * (1 + sum)), half_sin = safe_root(0.5f * (1 - sum));
  const float turn_cos = half_cos * cw + half_sin * sw, turn_sin = half_sin * cw - half_cos * sw;
  Vec3f aside = narrow.axis - wide.axis * apart;
  const float size = length(aside);
  aside = size > 1e-6f ? aside * (1 / size) : any_perpendicular(wide.axis);
  out.axis = normalized(wide.axis * turn_cos + aside * turn_sin);
  out.cos_spread = std::max(-1.0f, half_cos - 2e-6f);  // rounding must not exclude a normal
  return out;
}

struct LightTree::Item {
  LightBounds bounds;
  Vec3f middle;
  LightId light = 0;
};

/// Node of the binary tree that is built first.
struct LightTree::BuildNode {
  LightBounds bounds;
  uint32_t child = 0;  ///< First of a pair of nodes; for a leaf its light.
  bool leaf = false;

  float radius() const { return 0.5f * length(bounds.box.size()); }
  /// Estimated benefit of weighting its two children separately.
  float gain() const { return leaf ? -1 : bounds.strength * radius() * radius(); }
};

class LightTree::Builder {
 public:
  explicit Builder(std::vector<Item> items)
      : items_(std::move(items)), build_nodes_(2 * items_.size()) {
    build(0, items_.size(), 0, 2, 0);
  }
  /// Pairs at 2i and 2i + 1; the root is 0, and 1 is unused.
  const std::vector<BuildNode>& build_nodes() const { return build_nodes_; }

 private:
  void build(size_t begin, size_t end, uint32_t build_node, uint32_t below, int depth);

  std::vector<Item> items_;
  std::vector<BuildNode> build_nodes_;
};

LightTree::LightTree(size_t count, LightId first,
                     const std::function<LightBounds(size_t)>& bounds_of)
    : first_(first), leaves_(count, kNoNode) {
  std::vector<Item> items;
  for (size_t i = 0; i < count; ++i) {
    const LightBounds bounds = bounds_of(i);
    if (bounds.strength > 0 && !bounds.box.isEmpty())
      items.push_back({bounds, bounds.box.center(), first + static_cast<LightId>(i)});
  }
  size_ = items.size();
  if (!items.empty()) flatten(Builder(std::move(items)).build_nodes());
}

/// Builds `build_node` from the items [begin, end); its descendants start at `below`.
void LightTree::Builder::build(size_t begin, size_t end, uint32_t build_node, uint32_t below,
                               int depth) {
  std::vector<Item>& items = items_;
  const size_t count = end - begin;
  LightBounds all;
  Box3f middles;
  for (size_t i = begin; i < end; ++i) {
    all = union_of(all, items[i].bounds);
    middles.extendBy(items[i].middle);
  }
  if (count == 1) {
    build_nodes_[build_node] = {all, items[begin].light, true};
    return;
  }
  build_nodes_[build_node] = {all, below, false};

  size_t middle = begin + count / 2;
  int axis = -1;
  size_t border = 0;
  const Vec3f size = middles.size(), extent = all.box.size();
  const auto bin_of = [&](const Item& item, int along) {
    const float at = (item.middle[along] - middles.min[along]) / size[along];
    return std::min(static_cast<size_t>(at * static_cast<float>(kBins)), kBins - 1);
  };
  double least = kInfinity;
  for (int along = 0; along < 3 && count > 2 && depth < kMaxDepth; ++along) {
    if (!(size[along] > 0)) continue;
    std::array<LightBounds, kBins> bins{}, above{};
    for (size_t i = begin; i < end; i += 1 + count / kLarge) {
      LightBounds& bin = bins[bin_of(items[i], along)];
      bin = union_of(bin, items[i].bounds);
    }
    for (size_t b = kBins - 1; b > 0; --b)
      above[b - 1] = b == kBins - 1 ? bins[b] : union_of(above[b], bins[b]);
    LightBounds under;
    // Thin slices cost more, which favours splits of the longest side.
    const double regular =
        static_cast<double>(largest(extent)) / static_cast<double>(extent[along]);
    for (size_t b = 0; b + 1 < kBins; ++b) {
      under = union_of(under, bins[b]);
      if (!(under.strength > 0 && above[b].strength > 0)) continue;
      const double price = regular * (cost(under) + cost(above[b]));
      if (price < least) least = price, axis = along, border = b;
    }
  }
  const auto first = items.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = items.begin() + static_cast<std::ptrdiff_t>(end);
  if (axis >= 0) {
    const auto split = std::stable_partition(
        first, last, [&](const Item& item) { return bin_of(item, axis) <= border; });
    middle = static_cast<size_t>(split - items.begin());
  }
  if (middle == begin || middle == end || axis < 0) {
    middle = begin + count / 2;
    int longest = size.x >= size.y ? 0 : 1;
    if (size.z > size[longest]) longest = 2;
    std::nth_element(first, items.begin() + static_cast<std::ptrdiff_t>(middle), last,
                     [&](const Item& a, const Item& b) {
                       return a.middle[longest] != b.middle[longest]
                                  ? a.middle[longest] < b.middle[longest]
                                  : a.light < b.light;
                     });
  }
  const auto left_size = static_cast<uint32_t>(2 * (middle - begin) - 2);
  const auto side = [&](size_t which) {
    if (which == 0)
      build(begin, middle, below, below + 2, depth + 1);
    else
      build(middle, end, below + 1, below + 2 + left_size, depth + 1);
  };
  if (count > kLarge) {
    parallel_for(2, side);
  } else {
    side(0);
    side(1);
  }
}

/// Collapses the binary tree to wide nodes: in each, the child with the largest gain is split until
/// there are enough.
void LightTree::flatten(const std::vector<BuildNode>& build_nodes) {
  const auto part = [&](std::vector<uint32_t>& among, size_t enough) {
    while (among.size() < enough) {
      const auto best = std::max_element(among.begin(), among.end(), [&](uint32_t a, uint32_t b) {
        return build_nodes[a].gain() < build_nodes[b].gain();
      });
      if (build_nodes[*best].leaf) break;
      const uint32_t child = build_nodes[*best].child;
      *best = child;
      among.push_back(child + 1);
    }
  };
  std::vector<uint32_t> among{0};
  part(among, kMaxBranches);
  branches_ = among.size();
  nodes_.resize((branches_ + kWidth - 1) / kWidth);
  parents_.resize(nodes_.size());
  std::vector<uint32_t> source;  // binary node of each lane, node by node
  const auto fill = [&](size_t node) {
    Node& out = nodes_[node];
    for (size_t lane = 0; lane < std::min(among.size(), kWidth); ++lane) {
      const BuildNode& build_node = build_nodes[among[lane]];
      const LightBounds& b = build_node.bounds;
      const Vec3f center = b.box.center();
      out.x[lane] = center.x, out.y[lane] = center.y, out.z[lane] = center.z;
      out.radius[lane] = build_node.radius();
      out.axis_x[lane] = b.axis.x, out.axis_y[lane] = b.axis.y, out.axis_z[lane] = b.axis.z;
      out.cos_spread[lane] = b.cos_spread, out.cos_reach[lane] = b.cos_reach;
      out.sin_spread[lane] = safe_root(1 - b.cos_spread * b.cos_spread);
      out.strength[lane] = b.strength;
      out.child[lane] = build_node.leaf ? build_node.child | kLeaf : kNoNode & ~kLeaf;
      if (build_node.leaf)
        leaves_[build_node.child - first_] = static_cast<uint32_t>(node * kWidth + lane);
    }
    among.resize(kWidth);
    source.insert(source.end(), among.begin(), among.end());
  };
  std::vector<uint32_t> tops = among;
  for (size_t node = 0; node * kWidth < branches_; ++node) {
    const auto begin = tops.begin() + static_cast<std::ptrdiff_t>(node * kWidth);
    among.assign(begin,
                 begin + static_cast<std::ptrdiff_t>(std::min(kWidth, branches_ - node * kWidth)));
    fill(node);
  }
  for (size_t node = 0; node < nodes_.size(); ++node)
    for (size_t lane = 0; lane < kWidth; ++lane) {
      if (!(nodes_[node].strength[lane] > 0) || nodes_[node].is_leaf(lane)) continue;
      among = {source[node * kWidth + lane]};
      part(among, kWidth);
      const size_t below = nodes_.size();
      nodes_[node].child[lane] = static_cast<uint32_t>(below);
      nodes_.emplace_back();
      parents_.push_back(static_cast<uint32_t>(node * kWidth + lane));
      fill(below);
    }
}

LightTree::Weights LightTree::importance(const Node& node, const LightSampleContext& point) {
  constexpr float kRounding = 1e-4f;
  const Vec3f p = point.position, n = point.normal;
  const float least_height = point.on_surface() ? -kRounding : -kFar;
  Weights out;
  for (size_t i = 0; i < kWidth; ++i) {
    const float x = node.x[i] - p.x, y = node.y[i] - p.y, z = node.z[i] - p.z;
    const float squared = x * x + y * y + z * z, within = node.radius[i] * node.radius[i];
    const float inverse = 1 / std::sqrt(std::max(squared, 1e-30f));
    // The bounding sphere subtends this angle; the bounds of all angles are widened by it.
    const float sin_ball = node.radius[i] * inverse;
    const float cos_ball = std::sqrt(std::max(0.0f, 1 - sin_ball * sin_ball));
    // Smallest angle off the axis, less the spread of normals, then less the bounding sphere; each
    // is clamped to zero.
    const float turned = (node.axis_x[i] * x + node.axis_y[i] * y + node.axis_z[i] * z) * -inverse;
    const float cos_axis = std::min(std::max(turned, -1.0f), 1.0f);
    const float sin_axis = std::sqrt(std::max(0.0f, 1 - cos_axis * cos_axis));
    const float cos_spread = node.cos_spread[i], sin_spread = node.sin_spread[i];
    const bool spread = cos_axis > cos_spread;
    const float cos_off = spread ? 1 : cos_axis * cos_spread + sin_axis * sin_spread;
    const float sin_off = spread ? 0 : sin_axis * cos_spread - cos_axis * sin_spread;
    const float cos_leave = cos_off > cos_ball ? 1 : cos_off * cos_ball + sin_off * sin_ball;
    // Smallest angle off the surface normal, if there is one.
    const float raised = (n.x * x + n.y * y + n.z * z) * inverse;
    const float cos_normal = std::min(std::max(raised, -1.0f), 1.0f);
    const float sin_normal = std::sqrt(std::max(0.0f, 1 - cos_normal * cos_normal));
    const float cos_arrive =
        cos_normal > cos_ball ? 1 : cos_normal * cos_ball + sin_normal * sin_ball;
    const float strength = node.strength[i];
    const float facing = std::max(cos_leave, 0.05f) * std::max(cos_arrive, 0.02f);
    const float outside = strength * inverse * inverse * facing;
    const bool dark = (cos_leave < node.cos_reach[i] - kRounding) | (cos_arrive < least_height);
    const float inside = strength / std::max(within, 1e-12f);
    const float seen = dark ? 0.0f : outside;
    out[i] = squared > within ? seen : inside;
  }
  return out;
}

LightTree::Weights LightTree::importance_along(const Node& node, const Ray& ray, float begin,
                                               float end) {
  const Vec3f o = ray.origin, d = ray.direction;
  Weights out;
  for (size_t i = 0; i < kWidth; ++i) {
    const float x = node.x[i] - o.x, y = node.y[i] - o.y, z = node.z[i] - o.z;
    const float t = std::min(std::max(x * d.x + y * d.y + z * d.z, begin), end);
    const float dx = x - d.x * t, dy = y - d.y * t, dz = z - d.z * t;
    // Integrated over the ray, 1 / distance^2 gives about 1 / (nearest distance).
    const float nearest = std::sqrt(dx * dx + dy * dy + dz * dz);
    out[i] = node.strength[i] / std::max(nearest, std::max(node.radius[i], 1e-6f));
  }
  return out;
}

std::array<bool, LightTree::kWidth> LightTree::hit_lanes(const Node& node, const Ray& ray,
                                                         float end) {
  constexpr float kRounding = 1e-5f;
  const Vec3f o = ray.origin, d = ray.direction;
  std::array<bool, kWidth> out{};
  for (size_t i = 0; i < kWidth; ++i) {
    const float x = node.x[i] - o.x, y = node.y[i] - o.y, z = node.z[i] - o.z;
    const float t = std::min(std::max(x * d.x + y * d.y + z * d.z, 0.0f), end);
    const float dx = x - d.x * t, dy = y - d.y * t, dz = z - d.z * t;
    const float reach = node.radius[i] + kRounding * (t + node.radius[i]);
    out[i] = (node.strength[i] > 0) & (dx * dx + dy * dy + dz * dz <= reach * reach);
  }
  return out;
}

}  // namespace vug::render
