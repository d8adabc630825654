// SPDX-License-Identifier: Apache-2.0
// Access to the colours of an image by the indices of its channels R, G and B.
#pragma once

#include <vug/base/vec.h>
#include <vug/image/image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vug::image {

/// Tone curves are flat beyond this value; a cap prevents infinities from becoming NaN in matrices.
inline constexpr double kBrightest = 1e6;

inline double displayable(double v) { return std::isnan(v) ? 0.0 : std::clamp(v, 0.0, kBrightest); }

/// The indices of the channels R, G and B.
using Channels = std::array<size_t, 3>;

inline std::optional<Channels> colour_channels(const Image& image) {
  Channels out{};
  for (size_t i = 0; i < 3; ++i) {
    const int found = image.find_channel(std::string(1, "RGB"[i]));
    if (found < 0) return std::nullopt;
    out[i] = static_cast<size_t>(found);
  }
  return out;
}

inline Vec3d colour_at(const Image& image, size_t pixel, const Channels& from) {
  const float* values = &image.pixels[pixel * image.channels.size()];
  return {static_cast<double>(values[from[0]]), static_cast<double>(values[from[1]]),
          static_cast<double>(values[from[2]])};
}

}  // namespace vug::image
