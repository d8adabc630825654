// SPDX-License-Identifier: Apache-2.0
// Pictures of one value per pixel in colours of evenly increasing lightness.
#include <vug/base/srgb.h>
#include <vug/image/diff.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

/// sRGB colours at equal steps: black, plum, red, orange, pale yellow. Lightness increases evenly,
/// so the map is also readable in grey.
constexpr double kStops[][3] = {{0.02, 0.02, 0.05},
                                {0.28, 0.07, 0.42},
                                {0.70, 0.17, 0.36},
                                {0.96, 0.50, 0.25},
                                {1.00, 0.96, 0.75}};
constexpr int kSteps = 4;

}  // namespace

Image heat_map(const std::vector<float>& values, int width, int height) {
  Image out(width, height, {"R", "G", "B"});
  for (size_t p = 0; p < values.size(); ++p) {
    const double v = static_cast<double>(values[p]);
    const double t = kSteps * (std::isnan(v) ? 1.0 : std::clamp(v, 0.0, 1.0));
    const int step = std::min(static_cast<int>(t), kSteps - 1);
    for (size_t c = 0; c < 3; ++c)
      out.pixels[3 * p + c] = static_cast<float>(
          srgb_decode(kStops[step][c] + (t - step) * (kStops[step + 1][c] - kStops[step][c])));
  }
  return out;
}

}  // namespace vug::image
