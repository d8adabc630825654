// SPDX-License-Identifier: Apache-2.0
// Fields of many small solids.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/boolean.h>
#include <vug/field/opaque.h>
#include <vug/field/speleothems/element_list.h>
#include <vug/field/speleothems/element_tree.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace vug::field {

/// The union of elements, smoothed between the two nearest ones.
template <class E>
struct ElementSource {
  std::shared_ptr<const ElementTree<E>> tree;
  Blend blend;

  double value(const Vec3d& p) const { return value_below(p, kInfinity); }
  /// A value that is not below the limit may be any such number.
  double value_below(const Vec3d& p, double limit) const {
    const auto near = tree->nearest(p, blend.radius, element_limit(limit, blend));
    return near.two && near.second < near.first + blend.radius ? blend.smin(near.first, near.second)
                                                               : near.first;
  }
  Gradient sample(const Vec3d& p) const { return *sample_below(p, kInfinity); }
  /// Nothing if the value is not below the limit.
  std::optional<Gradient> sample_below(const Vec3d& p, double limit) const {
    const auto near = tree->nearest(p, blend.radius, element_limit(limit, blend));
    if (!near.one) return std::nullopt;
    const Point<Dual<double>> at = seeded(point(p));
    Dual<double> d = near.one->distance(at);
    if (near.two && near.second < near.first + blend.radius)
      d = blend.smin(d, near.two->distance(at));
    return Gradient{d.v, {d.dx, d.dy, d.dz}};
  }
};

/// Restricted to a ball, it is a list of the few elements that matter there.
template <class E>
class ElementTreeNode final : public OpaqueNode<ElementSource<E>>, public EvaluatesBelow {
 public:
  using OpaqueNode<ElementSource<E>>::OpaqueNode;

  Restriction restrict_to(const Ball& ball) const override {
    return restrict_below(ball, kInfinity);
  }
  Restriction restrict_below(const Ball& ball, double limit) const override {
    constexpr size_t kMost = 1024;  // More are found faster by the tree.
    const ElementSource<E>& source = this->source();
    const double slack = 1e-6 * (1 + ball.centre.length() + ball.radius);
    const double highest = limit + ball.radius + slack;
    const double value = source.value_below(ball.centre, highest);
    if (value >= highest) return {{std::nextafter(limit, kInfinity), kInfinity}, nullptr};
    Restriction out{this->centre_form(value, ball), nullptr};
    const double reach =
        std::min(nearby_limit(value, ball, source.blend), element_limit(highest, source.blend));
    std::vector<NearElement<E>> near;
    if (source.tree->within(ball.centre, reach, kMost, near))
      out.node = std::make_shared<ElementListNode<E>>(this->traits(), near, source.blend);
    return out;
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Pack* out,
                  Scratch&) const override {
    for (int i = 0; i < count; ++i)
      out[i] = lane_by_lane(points[i], limits[i], [&](const Vec3d& p, double limit) {
                 return Gradient{this->source().value_below(p, limit), {}};
               }).v;
  }
  void eval_below(const Point<Pack>* points, const Pack* limits, int count, Dual<Pack>* out,
                  Scratch&) const override {
    for (int i = 0; i < count; ++i)
      out[i] = lane_by_lane(points[i], limits[i], [&](const Vec3d& p, double limit) {
        return this->source().sample_below(p, limit).value_or(Gradient{limit, {}});
      });
  }

 private:
  template <class Sample>
  static Dual<Pack> lane_by_lane(const Point<Pack>& p, const Pack& limits, const Sample& sample) {
    float in[4][Pack::kLanes], out[4][Pack::kLanes];
    p.x.store(in[0]), p.y.store(in[1]), p.z.store(in[2]), limits.store(in[3]);
    for (int k = 0; k < Pack::kLanes; ++k) {
      const Gradient g =
          sample(Vec3d(Vec3f(in[0][k], in[1][k], in[2][k])), static_cast<double>(in[3][k]));
      out[0][k] = static_cast<float>(g.value);
      for (int axis = 0; axis < 3; ++axis) out[axis + 1][k] = static_cast<float>(g.gradient[axis]);
    }
    return {Pack::load(out[0]), Pack::load(out[1]), Pack::load(out[2]), Pack::load(out[3])};
  }
};

/// The union of the elements; see ElementTree for E. `exactness` is that of an element's distance.
/// With a smooth blend, each point blends its two nearest elements, so the order does not matter.
template <class E>
Field element_field(const std::string& name, std::vector<E> elements, Exactness exactness,
                    const Blend& blend = {}) {
  if (elements.empty()) return empty();
  const auto tree = std::make_shared<const ElementTree<E>>(std::move(elements));
  Traits traits{1, std::max(exactness, Exactness::eikonal), grown(tree->bounds(), blend.depth()),
                1};
  if (blend.radius > 0) traits.exactness = std::max(traits.exactness, Exactness::bound);
  return Field(
      std::make_shared<ElementTreeNode<E>>(name, std::move(traits), ElementSource<E>{tree, blend}));
}

}  // namespace vug::field
