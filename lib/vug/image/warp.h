// SPDX-License-Identifier: Apache-2.0
// Projective transformation of images.
#pragma once

#include <vug/base/vec.h>
#include <vug/image/image.h>

#include <array>

namespace vug::image {

/// (x, y) goes to (u / w, v / w), where (u, v, w) = m (x, y, 1); m row by row.
struct Homography {
  std::array<double, 9> m = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  Vec2d operator()(const Vec2d& p) const {
    const double w = m[6] * p.x + m[7] * p.y + m[8];
    return {(m[0] * p.x + m[1] * p.y + m[2]) / w, (m[3] * p.x + m[4] * p.y + m[5]) / w};
  }
};

/// Resamples the image into width x height pixels through `to_target`. Coordinates are in pixels
/// from the upper left corner, y down; the centre of the first pixel is (0.5, 0.5). The filter is a
/// Lanczos filter with three lobes [@duchon1979], as wide as the target pixel in the source
/// image and at least one source pixel; the image is 0 beyond its border. Channels without negative
/// values stay non-negative. Throws Error(bad_input) for sizes that are not positive.
Image warped(const Image& picture, const Homography& to_target, int width, int height);

}  // namespace vug::image
