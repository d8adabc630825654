// SPDX-License-Identifier: Apache-2.0
// Synthetic facades: sky, stone with noise, rows of glass windows, a shop below.
#pragma once

#include <vug/base/rng.h>
#include <vug/fit/model/model.h>
#include <vug/image/image.h>

#include <vector>

namespace vug::fit {

/// Classes of the labels.
enum Painted : uint8_t { kDoor, kShop, kWindow, kStone, kSky };

struct PaintedFacade {
  image::Image photo;
  std::vector<uint8_t> classes;
  std::vector<Rect> windows;

  int width() const { return photo.width; }
  int height() const { return photo.height; }
};

/// Windows in `columns` x `rows`; `number` selects lighting, positions and noise.
inline PaintedFacade painted(int number, int width = 120, int height = 160, int columns = 4,
                             int rows = 3) {
  RandomStream stream(RandomKey(7).at(static_cast<uint64_t>(number)));
  PaintedFacade out;
  out.photo = image::Image(width, height, {"R", "G", "B"});
  out.classes.assign(out.photo.pixel_count(), kStone);
  const auto fill = [&](const Rect& r, uint8_t what) {
    for (int y = r.y0; y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x)
        out.classes[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
            what;
  };
  const int sky = height / 8, floor = height * 13 / 16;
  fill({0, 0, width, sky}, kSky);
  fill({0, floor, width, height}, kShop);
  fill({width / 2 - 5, floor + 3, width / 2 + 5, height}, kDoor);
  const int pitch_x = width / columns, pitch_y = (floor - sky) / rows;
  const int wide = pitch_x / 2, high = pitch_y * 3 / 5;
  const int left = static_cast<int>(stream.below(static_cast<uint32_t>(pitch_x - wide)));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x = column * pitch_x + left, y = sky + row * pitch_y + pitch_y / 5;
      out.windows.push_back({x, y, x + wide, y + high});
      fill(out.windows.back(), kWindow);
    }
  // Linear colour of each class.
  constexpr float kColours[5][3] = {{0.10f, 0.05f, 0.02f},
                                    {0.20f, 0.06f, 0.05f},
                                    {0.10f, 0.13f, 0.18f},
                                    {0.50f, 0.42f, 0.30f},
                                    {0.60f, 0.70f, 0.90f}};
  const double light = stream.uniform(0.7, 1.3);
  for (size_t i = 0; i < out.classes.size(); ++i) {
    // Frames and panes: stripes in each window.
    const bool bar = out.classes[i] == kWindow && (i % static_cast<size_t>(width)) % 5 == 0;
    for (size_t c = 0; c < 3; ++c)
      out.photo.pixels[3 * i + c] = static_cast<float>(
          light * (kColours[out.classes[i]][c] + (bar ? 0.3 : 0) + stream.uniform(-0.03, 0.03)));
  }
  return out;
}

/// Intersection over union of two pixel sets.
inline double overlap(const std::vector<bool>& a, const std::vector<bool>& b) {
  double both = 0, any = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    both += a[i] && b[i] ? 1 : 0;
    any += a[i] || b[i] ? 1 : 0;
  }
  return any > 0 ? both / any : 0;
}

}  // namespace vug::fit
