// SPDX-License-Identifier: Apache-2.0
// Distances in the plane and their extension to solids, shared by the primitives with flat faces or
// faces of revolution about the y axis (quilez2008distance; hart1996). Each formula uses the signed
// distance to a face's line wherever that face is nearest, and a square root only at edges, so the
// gradient is defined on the surface itself, where a root has none.
#pragma once

#include <vug/field/point.h>

namespace vug::field {

/// The exact distance to the intersection of two orthogonal solids: d and e are the exact distances
/// to each, along orthogonal axes (a profile and a slab, the two slabs of a rectangle).
template <class T>
T intersect_orthogonal(const T& d, const T& e) {
  const T inside = max(d, e);
  return select(inside > T(0.0), length(max(d, T(0.0)), max(e, T(0.0))), inside);
}

/// A straight edge of a convex profile, from `a` to `b` with the solid on the left.
class ProfileEdge {
 public:
  ProfileEdge(double ax, double ay, double bx, double by)
      : ax_(ax), ay_(ay), length_(std::sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))) {
    tx_ = (bx - ax) / length_;
    ty_ = (by - ay) / length_;
  }
  /// Signed distance to the edge's line, positive outside.
  template <class T>
  T height(const T& x, const T& y) const {
    return (x - T(ax_)) * T(ty_) - (y - T(ay_)) * T(tx_);
  }
  /// True if the projection of the point onto the line lies between a and b.
  template <class T>
  auto projects_onto(const T& x, const T& y) const {
    const T along = (x - T(ax_)) * T(tx_) + (y - T(ay_)) * T(ty_) - T(0.5 * length_);
    return abs(along) < T(0.5 * length_);
  }

 private:
  double ax_, ay_, length_, tx_ = 0, ty_ = 0;
};

/// The solid between y = -half_height, with half-width `low`, and y = half_height, with half-width
/// `high`; x >= 0. At most one of the widths may be 0.
class Trapezoid {
 public:
  Trapezoid(double low, double high, double half_height)
      : low_(low),
        high_(high),
        half_height_(half_height),
        side_(low, -half_height, high, half_height) {}

  template <class T>
  T distance(const T& x, const T& y) const {
    const T slant = side_.height(x, y), cap = abs(y) - T(half_height_);
    const T inside = max(slant, cap);
    const T below = square(max(x - T(low_), T(0.0))) + square(y + T(half_height_));
    const T above = square(max(x - T(high_), T(0.0))) + square(y - T(half_height_));
    const T outside =
        select(both(slant > T(0.0), side_.projects_onto(x, y)), slant, sqrt(min(below, above)));
    return select(inside > T(0.0), outside, inside);
  }

 private:
  double low_, high_, half_height_;
  ProfileEdge side_;
};

}  // namespace vug::field
