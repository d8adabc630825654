// SPDX-License-Identifier: Apache-2.0
// Binary masks and their morphology with square structuring elements [@serra1982].
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vug::scan {

/// Row by row from the top; 1 is on, 0 is off.
struct Mask {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> on;

  Mask() = default;
  Mask(int w, int h, bool value = false)
      : width(w), height(h), on(static_cast<size_t>(w) * static_cast<size_t>(h), value) {}

  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  bool at(int x, int y) const { return on[index(x, y)] != 0; }
};

/// Pixels x0 <= x < x1, y0 <= y < y1; y points down.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int64_t area() const { return int64_t{x1 - x0} * (y1 - y0); }
  bool operator==(const PixelBox&) const = default;
};

/// A length in whole pixels, at most `most`.
int pixels_of(double metres, double pixel, int most);

Mask inverted(Mask mask);
/// Dilation and erosion by the square of 2 radius + 1 pixels; pixels beyond the border are ignored.
Mask dilated(const Mask& mask, int radius);
Mask eroded(const Mask& mask, int radius);
/// Dilation, then erosion: turns on gaps that are nowhere wider than the square.
Mask closed(const Mask& mask, int radius);
/// Erosion, then dilation: turns off structures narrower than the square.
Mask opened(const Mask& mask, int radius);

/// Off pixels that are connected to the left, right or upper border through off pixels.
Mask outside_of(const Mask& solid);

/// A connected component of on pixels (4-connectivity) with a mask cropped to its bounding box.
struct Component {
  PixelBox box;
  Mask mask;  ///< Has the size of `box`.
  int64_t pixels = 0;
};
/// Visits the components in the order of their first pixels. One component is created at a time,
/// because bounding boxes may overlap heavily.
void each_component(const Mask& mask, const std::function<void(const Component&)>& visit);
/// All components at once.
std::vector<Component> components_of(const Mask& mask);

}  // namespace vug::scan
