// Pixels that are on or off, and the morphology of squares [@serra1982].
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vug::scan {

/// Row by row from the top; 1 is on, 0 off.
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

/// Pixels from x0 to x1 and y0 to y1, without x1 and y1; y downwards.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int64_t area() const { return int64_t{x1 - x0} * (y1 - y0); }
  bool operator==(const PixelBox&) const = default;
};

/// A length in whole pixels, at most `most`.
int pixels_of(double metres, double pixel, int most);

Mask inverted(Mask mask);
/// On where a pixel within the square of 2 radius + 1 pixels is on; what lies beyond the border
/// counts for neither.
Mask dilated(const Mask& mask, int radius);
Mask eroded(const Mask& mask, int radius);
/// Dilated, then eroded: what is off and nowhere wider than the square comes on.
Mask closed(const Mask& mask, int radius);
/// Eroded, then dilated: what is on and narrower than the square goes off.
Mask opened(const Mask& mask, int radius);

/// What is off and touches the left, right or upper border through pixels that are off.
Mask outside_of(const Mask& solid);

/// Pixels that are on and touch along their sides, by rows: one mask a group, cut out of the box
/// it lies in.
struct Component {
  PixelBox box;
  Mask mask;  ///< Of the box's size.
  int64_t pixels = 0;
};
/// In the order of their first pixels. One group at a time is made, as boxes may overlap a lot.
void each_component(const Mask& mask, const std::function<void(const Component&)>& visit);
/// All at once.
std::vector<Component> components_of(const Mask& mask);

}  // namespace vug::scan
