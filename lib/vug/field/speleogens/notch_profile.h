// SPDX-License-Identifier: Apache-2.0
// The section of a notch that water cut into a wall (lange1962): a flat roof and a sloping facet.
#pragma once

#include <vug/field/point.h>

#include <algorithm>

namespace vug::field {

struct NotchProfile {
  double height = 0.6;  ///< From the roof to the foot of the facet, metres.
  double roof = 0.1;    ///< Height of the roof's edge over the height, above 0.

  /// Depth at a distance below the roof in metres: 0 at the roof and at the foot, at most 1 near
  /// the edge of the roof, and negative beyond both.
  template <class T>
  T depth(const T& below_roof) const {
    const T below = below_roof * T(1 / height);
    return min(min(below * T(1 / roof), (T(1.0) - below) * T(1 / (1 - deepest()))), T(1.0));
  }
  /// The maximum slope of the depth, per metre.
  double slope() const { return std::max(1 / roof, 1 / (1 - deepest())) / height; }

 private:
  /// The fraction of the height at which the notch is deepest.
  double deepest() const { return std::min(roof, 0.5); }
};

}  // namespace vug::field
