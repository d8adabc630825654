// Rectangles on a facade's plane and how they are stamped: metres, x to the right, y up.
#pragma once

namespace vug::facade {

struct Rect {
  double x = 0, y = 0;  ///< Lower left corner.
  double width = 0, height = 0;

  double right() const { return x + width; }
  double top() const { return y + height; }
  bool operator==(const Rect&) const = default;
};

/// Shifts, or mirrors about an upright line and shifts.
struct Placement {
  double x = 0, y = 0;
  bool mirrored = false;

  Rect operator()(const Rect& r) const {
    return {mirrored ? x - r.right() : x + r.x, y + r.y, r.width, r.height};
  }
  /// First `inner`, then this.
  Placement after(const Placement& inner) const {
    return {mirrored ? x - inner.x : x + inner.x, y + inner.y, mirrored != inner.mirrored};
  }
  bool operator==(const Placement&) const = default;

  static Placement shift(double x, double y) { return {x, y, false}; }
  /// About the upright line at `x`.
  static Placement mirror(double x) { return {2 * x, 0, true}; }
};

}  // namespace vug::facade
