// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/evidence/box_filter.h>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

template <class Value>
Plane generate(int width, int height, const Value& value) {
  Plane out;
  out.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) out.push_back(static_cast<float>(value(x, y)));
  return out;
}

}  // namespace

BoxFilter::BoxFilter(int width, int height, const Plane& plane)
    : width_(width),
      height_(height),
      table_((static_cast<size_t>(width) + 1) * (static_cast<size_t>(height) + 1), 0) {
  size_t i = 0;
  for (int y = 0; y < height; ++y) {
    double row = 0;
    for (int x = 0; x < width; ++x) {
      row += plane[i++];
      table_[index(x + 1, y + 1)] = table_[index(x + 1, y)] + row;
    }
  }
}

Plane BoxFilter::mean(int half_x, int half_y) const {
  return generate(width_, height_, [&](int x, int y) {
    const int x0 = std::max(0, x - half_x), x1 = std::min(width_, x + half_x + 1);
    const int y0 = std::max(0, y - half_y), y1 = std::min(height_, y + half_y + 1);
    return (table_[index(x1, y1)] - table_[index(x0, y1)] - table_[index(x1, y0)] +
            table_[index(x0, y0)]) /
           (static_cast<double>(x1 - x0) * (y1 - y0));
  });
}

Plane difference(const Plane& a, const Plane& b) {
  Plane out(a);
  for (size_t i = 0; i < out.size(); ++i) out[i] -= b[i];
  return out;
}

Plane squared(const Plane& plane) {
  Plane out(plane);
  for (float& v : out) v *= v;
  return out;
}

Plane central_differences(int width, int height, const Plane& plane, bool along_x) {
  const auto at = [&](int x, int y) {
    return plane[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
  };
  return generate(width, height, [&](int x, int y) {
    const int x0 = along_x ? std::max(0, x - 1) : x, y0 = along_x ? y : std::max(0, y - 1);
    const int x1 = along_x ? std::min(width - 1, x + 1) : x;
    const int y1 = along_x ? y : std::min(height - 1, y + 1);
    return std::fabs(at(x1, y1) - at(x0, y0));
  });
}

}  // namespace vug::fit
