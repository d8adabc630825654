// SPDX-License-Identifier: Apache-2.0
// Synthetic views whose terms have closed forms.
#pragma once

#include <vug/scout/view.h>

namespace vug::scout {

/// The view whose pixel at the film position (u, v) is `pixel(u, v)`.
template <class Pixel>
View view_of(Pixel pixel) {
  View view(kViewWidth, kViewHeight);
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      view.at(x, y) = pixel((x + 0.5) / view.width, (y + 0.5) / view.height);
  return view;
}

inline Seen surface(double distance, const Vec3f& normal = {1, 0, 0}, uint32_t object = 0) {
  Seen seen;
  seen.distance = static_cast<float>(distance);
  seen.normal = normal;
  seen.object = object;
  seen.albedo = 0.5f;
  return seen;
}

}  // namespace vug::scout
