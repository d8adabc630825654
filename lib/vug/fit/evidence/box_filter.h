// Planes filtered with boxes, by sums over rectangles (cite crow1984).
#pragma once

#include <cstddef>
#include <vector>

namespace vug::fit {

/// A number for each pixel, row after row from the top.
using Plane = std::vector<float>;

/// Means of a plane over boxes around each pixel: over the part of each box that is in the picture.
/// Sizes are half of a box's, in pixels, beside the pixel itself.
class BoxFilter {
 public:
  BoxFilter(int width, int height, const Plane& plane);

  Plane mean(int half_x, int half_y) const;
  Plane mean(int half) const { return mean(half, half); }
  /// Over whole rows, `half` of them to either side, whole columns, and the whole picture.
  Plane rows(int half) const { return mean(width_, half); }
  Plane columns(int half) const { return mean(half, height_); }
  Plane whole() const { return mean(width_, height_); }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * (static_cast<size_t>(width_) + 1) + static_cast<size_t>(x);
  }

  int width_, height_;
  std::vector<double> table_;  ///< Of what lies above and to the left.
};

/// Each value less the other's; each value's square.
Plane difference(const Plane& a, const Plane& b);
Plane squared(const Plane& plane);
/// How much the plane changes from the pixel before to the one behind, along x or y.
Plane central_differences(int width, int height, const Plane& plane, bool along_x);

/// What sizes of boxes grow with, so that pictures of one facade at two resolutions have like
/// features: 1/160 of the height, a pixel at least.
inline int box_unit(int height) { return height / 160 > 1 ? height / 160 : 1; }

}  // namespace vug::fit
