// SPDX-License-Identifier: Apache-2.0
// A ball as one of many elements.
#pragma once

#include <vug/field/node.h>

namespace vug::field {

struct Lobe {
  Vec3d centre;
  double radius = 0;

  template <class T>
  T distance(const Point<T>& p) const {
    return length(p - constant<T>(centre)) - T(radius);
  }
  Ball ball() const { return {centre, radius}; }
};

}  // namespace vug::field
