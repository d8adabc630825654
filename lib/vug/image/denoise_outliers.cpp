// SPDX-License-Identifier: Apache-2.0
#include <vug/image/denoise_outliers.h>

#include <algorithm>
#include <array>

namespace vug::image {
namespace {

constexpr int kRadius = 2;       ///< The radius of the neighbourhood that sets the limit.
constexpr float kSpread = 3;     ///< The limit in distances of the quartiles above the upper one.
constexpr float kErrors = 1.5f;  ///< Larger differences in standard errors are not noise.
constexpr int kWindow = 8;       ///< Radius of the window in which similar pixels are counted.
constexpr float kMostSimilar = 1.0f / 16;  ///< Largest share of similar pixels around an outlier.

float pixel_luminance(const PixelValues* of, size_t p) {
  return 0.2126f * of[0][p] + 0.7152f * of[1][p] + 0.0722f * of[2][p];
}

/// Calls `each` for the pixels around (x, y), without that pixel.
template <class Each>
void for_each_around(const DenoiseInputs& in, int x, int y, int radius, const Each& each) {
  for (int v = std::max(0, y - radius); v <= std::min(in.height - 1, y + radius); ++v)
    for (int u = std::max(0, x - radius); u <= std::min(in.width - 1, x + radius); ++u)
      if (u != x || v != y) each(in.at(u, v));
}

struct Surroundings {
  float median, limit;  ///< The limit is the largest value that is not an outlier.
};

Surroundings surroundings(const DenoiseInputs& in, const PixelValues& light, int x, int y) {
  std::array<float, (2 * kRadius + 1) * (2 * kRadius + 1)> around{};
  size_t count = 0;
  for_each_around(in, x, y, kRadius, [&](size_t q) { around[count++] = light[q]; });
  if (count == 0) return {light[in.at(x, y)], light[in.at(x, y)]};
  std::sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count));
  const float lower = around[count / 4], upper = around[3 * count / 4];
  return {around[count / 2], upper + kSpread * (upper - lower)};
}

bool is_rare(const DenoiseInputs& in, const PixelValues& light, float median, int x, int y) {
  const float least = 0.5f * (light[in.at(x, y)] + median);
  size_t similar = 0, all = 0;
  for_each_around(in, x, y, kWindow, [&](size_t q) { similar += light[q] >= least, ++all; });
  return static_cast<float>(similar) <= kMostSimilar * static_cast<float>(all);
}

}  // namespace

void limit_outliers(DenoiseInputs& in) {
  PixelValues light(in.colour[0].size());
  for (size_t p = 0; p < light.size(); ++p) light[p] = pixel_luminance(in.colour, p);
  for (int y = 0; y < in.height; ++y)
    for (int x = 0; x < in.width; ++x) {
      const size_t p = in.at(x, y);
      const Surroundings around = surroundings(in, light, x, y);
      const float excess = light[p] - around.limit;
      if (!(excess > 0) || excess * excess > kErrors * kErrors * pixel_luminance(in.variance, p) ||
          !is_rare(in, light, around.median, x, y))
        continue;
      const float share = around.median / light[p];
      for (size_t c = 0; c < 3; ++c) {
        in.colour[c][p] *= share;
        in.variance[c][p] *= share * share;
      }
    }
}

}  // namespace vug::image
