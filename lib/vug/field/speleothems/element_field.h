// SPDX-License-Identifier: Apache-2.0
// Fields of many small solids.
#pragma once

#include <vug/field/blend.h>
#include <vug/field/boolean.h>
#include <vug/field/opaque.h>
#include <vug/field/speleothems/element_list.h>
#include <vug/field/speleothems/element_tree.h>

#include <string>

namespace vug::field {

/// The union of elements, smoothed between the two nearest ones.
template <class E>
struct ElementSource {
  std::shared_ptr<const ElementTree<E>> tree;
  Blend blend;

  double value(const Vec3d& p) const {
    const auto near = tree->nearest(p, blend.radius);
    return near.second < near.first + blend.radius ? blend.smin(near.first, near.second)
                                                   : near.first;
  }
  NodePtr restricted(const Ball& ball, const Traits& traits) const {
    constexpr size_t kMost = 1024;  // More are found faster by the tree.
    const double reach = nearby_limit(value(ball.centre), ball, blend);
    std::vector<NearElement<E>> near;
    if (!tree->within(ball.centre, reach, kMost, near)) return nullptr;
    return std::make_shared<ElementListNode<E>>(traits, near, blend);
  }
  Gradient sample(const Vec3d& p) const {
    const auto near = tree->nearest(p, blend.radius);
    const Point<Dual<double>> at = seeded(point(p));
    Dual<double> d = near.one->distance(at);
    if (near.second < near.first + blend.radius) d = blend.smin(d, near.two->distance(at));
    return {d.v, {d.dx, d.dy, d.dz}};
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
  return Field(std::make_shared<OpaqueNode<ElementSource<E>>>(name, std::move(traits),
                                                              ElementSource<E>{tree, blend}));
}

}  // namespace vug::field
