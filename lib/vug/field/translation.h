// SPDX-License-Identifier: Apache-2.0
// Internal to field/: the map of a translation.
#pragma once

#include <vug/field/node.h>

namespace vug::field {

/// Most solids of a grammar are only translated, which costs three additions. See DeformerNode.
struct Translation {
  Vec3d by;

  template <class T>
  Point<T> map(const Point<T>& p) const {
    return {p.x - by.x, p.y - by.y, p.z - by.z};
  }
  template <class S>
  Point<S> pull_back(const Point<S>& g) const {
    return g;
  }
  Ball map(const Ball& ball) const { return {ball.centre - by, ball.radius}; }
  double scale() const { return 1; }
  Traits traits(const Traits& child) const { return child.translated(by); }
  NodePtr translated(const NodePtr& child, const Vec3d& more) const;
};

}  // namespace vug::field
