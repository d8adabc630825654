#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/render/light_tree.h>

#include <array>
#include <cmath>

namespace vug::render {
namespace {

constexpr size_t kBins = 12;
/// Larger branches are built in parallel, and judged by this many of their lights.
constexpr size_t kLarge = 65536;
/// Below this depth branches are halved, so that walks need no more than a small stack.
constexpr int kDeepest = 44;

float safe_root(float x) { return std::sqrt(std::max(0.0f, x)); }

/// Cosine and sine of max(0, a - b) for angles in [0, pi].
struct Angle {
  float cos, sin;
};
Angle minus(const Angle& a, const Angle& b) {
  if (a.cos > b.cos) return {1, 0};
  return {a.cos * b.cos + a.sin * b.sin, a.sin * b.cos - a.cos * b.sin};
}

Vec3f any_perpendicular(const Vec3f& v) { return Frame(v).x; }

/// The part of a branch's cost that its directions make: the integral of the cosine beyond the
/// reach over the cone of normals (Conty Estevez and Kulla 2018, equation 1).
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

/// Cones in cosines and sines only; where the union is wider than a half turn it becomes all
/// directions, which is no loss: such a branch says nothing about directions.
LightBounds united(const LightBounds& a, const LightBounds& b) {
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
  if (cw <= -1 || apart >= cw * cn + sw * sn) return out;  // the wide one holds the other
  const float c1 = cw * cn - sw * sn, s1 = sw * cn + cw * sn;
  if (cw + cn <= 0 || c1 + apart <= 0) {
    out.cos_spread = -1;
    return out;
  }
  // Half of the sum of both spreads and the angle between them.
  const float sum = c1 * apart - s1 * safe_root(1 - apart * apart);
  const float half_cos = safe_root(0.5f * (1 + sum)), half_sin = safe_root(0.5f * (1 - sum));
  const float turn_cos = half_cos * cw + half_sin * sw, turn_sin = half_sin * cw - half_cos * sw;
  Vec3f aside = narrow.axis - wide.axis * apart;
  const float size = length(aside);
  aside = size > 1e-6f ? aside * (1 / size) : any_perpendicular(wide.axis);
  out.axis = normalized(wide.axis * turn_cos + aside * turn_sin);
  out.cos_spread = std::max(-1.0f, half_cos - 2e-6f);  // rounding must not cut a normal off
  return out;
}

struct LightTree::Item {
  LightBounds bounds;
  Vec3f middle;
  LightId light = 0;
};

LightTree::LightTree(size_t count, LightId first,
                     const std::function<LightBounds(size_t)>& bounds_of)
    : first_(first), leaves_(count, kNowhere) {
  std::vector<Item> items;
  for (size_t i = 0; i < count; ++i) {
    const LightBounds bounds = bounds_of(i);
    if (bounds.strength > 0 && !bounds.box.isEmpty())
      items.push_back({bounds, bounds.box.center(), first + static_cast<LightId>(i)});
  }
  size_ = items.size();
  if (items.empty()) return;
  nodes_.resize(2 * items.size());
  build(items, 0, items.size(), 0, 2, 0);
  nodes_[0].parent &= kLeaf;
  make_cut();
}

/// Node `node` for the items [begin, end); the nodes below it begin at `below`.
void LightTree::build(std::vector<Item>& items, size_t begin, size_t end, uint32_t node,
                      uint32_t below, int depth) {
  const size_t count = end - begin;
  LightBounds all;
  Box3f middles;
  for (size_t i = begin; i < end; ++i) {
    all = united(all, items[i].bounds);
    middles.extendBy(items[i].middle);
  }
  Node& out = nodes_[node];
  const uint32_t parent = out.parent;
  out = {};
  out.box = all.box, out.axis = all.axis, out.strength = all.strength;
  out.cos_spread = all.cos_spread, out.cos_reach = all.cos_reach;
  out.sin_spread = safe_root(1 - all.cos_spread * all.cos_spread);
  const Vec3f half = all.box.size() * 0.5f;
  out.radius = length(half);
  out.parent = parent;
  if (count == 1) {
    out.child = items[begin].light;
    out.parent |= kLeaf;
    leaves_[out.child - first_] = node;
    return;
  }

  size_t middle = begin + count / 2;
  int axis = -1;
  size_t border = 0;
  const Vec3f size = middles.size(), extent = all.box.size();
  const auto bin_of = [&](const Item& item, int along) {
    const float at = (item.middle[along] - middles.min[along]) / size[along];
    return std::min(static_cast<size_t>(at * static_cast<float>(kBins)), kBins - 1);
  };
  double least = kInfinity;
  for (int along = 0; along < 3 && count > 2 && depth < kDeepest; ++along) {
    if (!(size[along] > 0)) continue;
    std::array<LightBounds, kBins> bins{}, above{};
    for (size_t i = begin; i < end; i += 1 + count / kLarge) {
      LightBounds& bin = bins[bin_of(items[i], along)];
      bin = united(bin, items[i].bounds);
    }
    for (size_t b = kBins - 1; b > 0; --b)
      above[b - 1] = b == kBins - 1 ? bins[b] : united(above[b], bins[b]);
    LightBounds under;
    // Thin slices cost more: the longest side should be cut.
    const double regular =
        static_cast<double>(largest(extent)) / static_cast<double>(extent[along]);
    for (size_t b = 0; b + 1 < kBins; ++b) {
      under = united(under, bins[b]);
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
  out.child = below;
  nodes_[below].parent = nodes_[below + 1].parent = node;
  const auto left_size = static_cast<uint32_t>(2 * (middle - begin) - 2);
  const auto side = [&](size_t which) {
    if (which == 0)
      build(items, begin, middle, below, below + 2, depth + 1);
    else
      build(items, middle, end, below + 1, below + 2 + left_size, depth + 1);
  };
  if (count > kLarge) {
    parallel_for(2, side);
  } else {
    side(0);
    side(1);
  }
}

/// From the root on, the strongest and widest branch is replaced by its two sides.
void LightTree::make_cut() {
  cut_ = {0};
  while (cut_.size() < kCutSize) {
    size_t best = cut_.size();
    float most = -1;
    for (size_t i = 0; i < cut_.size(); ++i) {
      const Node& node = nodes_[cut_[i]];
      const float gain = node.strength * node.radius * node.radius;
      if (!is_leaf(cut_[i]) && gain > most) best = i, most = gain;
    }
    if (best == cut_.size()) break;
    const uint32_t child = nodes_[cut_[best]].child;
    cut_[best] = child;
    cut_.push_back(child + 1);
  }
  for (size_t i = 0; i < cut_.size(); ++i) {
    Node& node = nodes_[cut_[i]];
    node.parent = (node.parent & kLeaf) | kCut | static_cast<uint32_t>(i);
  }
}

float LightTree::importance(uint32_t index, const LitPoint& point) const {
  const Node& node = nodes_[index];
  const Vec3f to = (node.box.min + node.box.max) * 0.5f - point.position;
  const float squared = dot(to, to);
  if (!(squared > node.radius * node.radius))
    return node.strength / std::max(node.radius * node.radius, 1e-12f);
  const float inverse = 1 / std::sqrt(squared);
  // The ball around the box fills this angle; all that is sure is measured less it.
  const float sine = node.radius * inverse;
  const Angle ball{safe_root(1 - sine * sine), sine};
  const auto angle = [](float cosine) {
    const float c = std::clamp(cosine, -1.0f, 1.0f);
    return Angle{c, safe_root(1 - c * c)};
  };
  constexpr float kRounding = 1e-4f;
  float weight = node.strength * inverse * inverse;
  if (node.cos_spread > -1) {
    const Angle off = minus(
        minus(angle(-dot(node.axis, to) * inverse), {node.cos_spread, node.sin_spread}), ball);
    if (off.cos < node.cos_reach - kRounding) return 0;
    weight *= std::max(off.cos, 0.05f);
  }
  if (point.on_surface()) {
    const Angle height = minus(angle(dot(point.normal, to) * inverse), ball);
    if (height.cos < -kRounding) return 0;
    weight *= std::max(height.cos, 0.02f);
  }
  return weight;
}

float LightTree::importance_along(uint32_t index, const Ray& ray, float begin, float end) const {
  const Node& node = nodes_[index];
  const Vec3f middle = (node.box.min + node.box.max) * 0.5f;
  const float t = std::clamp(dot(middle - ray.origin, ray.direction), begin, end);
  // Integrated over the ray, 1 / distance^2 gives about 1 / (nearest distance).
  return node.strength / std::max(length(middle - ray.at(t)), std::max(node.radius, 1e-6f));
}

}  // namespace vug::render
