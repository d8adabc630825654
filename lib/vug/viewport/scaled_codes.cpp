// SPDX-License-Identifier: Apache-2.0
#include <vug/viewport/scaled_codes.h>

#include <algorithm>

namespace vug::viewport {

std::vector<uint8_t> scaled_codes(const std::vector<uint8_t>& rgb, int from_width, int from_height,
                                  int width, int height) {
  std::vector<uint8_t> out(static_cast<size_t>(3 * width * height));
  if (rgb.empty()) return out;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int from = (y * from_height / height) * from_width + x * from_width / width;
      std::copy_n(rgb.begin() + 3 * from, 3, out.begin() + 3 * (y * width + x));
    }
  return out;
}

}  // namespace vug::viewport
