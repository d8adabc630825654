// SPDX-License-Identifier: Apache-2.0
// Rectangles on a facade's plane and placements of their copies: metres, x to the right, y up.
#pragma once

namespace vug::facade {

struct Rect {
  double x = 0, y = 0;  ///< Lower left corner.
  double width = 0, height = 0;

  double right() const { return x + width; }
  double top() const { return y + height; }
  bool operator==(const Rect&) const = default;
};

/// A translation, optionally preceded by a reflection about a vertical line.
struct Placement {
  double x = 0, y = 0;
  bool mirrored = false;

  Rect operator()(const Rect& r) const {
    return {mirrored ? x - r.right() : x + r.x, y + r.y, r.width, r.height};
  }
  /// The composition: first `inner`, then this.
  Placement after(const Placement& inner) const {
    return {mirrored ? x - inner.x : x + inner.x, y + inner.y, mirrored != inner.mirrored};
  }
  bool operator==(const Placement&) const = default;

  static Placement shift(double x, double y) { return {x, y, false}; }
  /// The reflection about the vertical line at `x`.
  static Placement mirror(double x) { return {2 * x, 0, true}; }
};

}  // namespace vug::facade
