// SPDX-License-Identifier: Apache-2.0
// A tiny picture of the surfaces that a camera sees, without light.
#pragma once

#include <vug/base/vec.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace vug::scout {

/// The id of pixels that see the sky.
inline constexpr uint32_t kSky = ~0u;

/// The surface that a pixel sees.
struct Seen {
  float distance = std::numeric_limits<float>::infinity();  ///< From the eye; infinite: sky.
  uint32_t object = kSky;                                   ///< Its index in the scene.
  Vec3f normal{0.0f};                                       ///< Unit, towards the eye.
  Vec3f origin{0.0f};   ///< Where rays that leave the surface start.
  float albedo = 0;     ///< Luminance of its base colour, 0 to 1.
  float emission = 0;   ///< Luminance that the surface emits, W/(m^2 sr).
  bool inside = false;  ///< The eye sees the back of the surface, from inside a solid.
};

/// Row 0 is the top row.
struct View {
  int width = 0, height = 0;
  std::vector<Seen> pixels;

  View() = default;
  View(int w, int h)
      : width(w), height(h), pixels(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  const Seen& at(int x, int y) const { return pixels[index(x, y)]; }
  Seen& at(int x, int y) { return pixels[index(x, y)]; }
  bool shows_sky(int x, int y) const { return at(x, y).object == kSky; }
};

/// The median distance of all pixels; infinite if most of them see the sky.
double median_distance(const View& view);

/// Width and height of the views that are scored.
inline constexpr int kViewWidth = 64, kViewHeight = 36;

}  // namespace vug::scout
