// Pictures seen from elsewhere: maps of the plane that keep straight lines straight.
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

/// The picture of width x height pixels to which `to_target` takes the given one's. Places are in
/// pixels from the upper left corner, y down; the middle of the first pixel is (0.5, 0.5). Each
/// pixel is what a Lanczos filter of three lobes [@duchon1979] takes in, as wide as the pixel is in
/// the given picture, one pixel of that at least; what lies beyond the picture is 0. Values of
/// channels without negative ones stay so. Error(bad_input) for sizes that are not positive.
Image warped(const Image& picture, const Homography& to_target, int width, int height);

}  // namespace vug::image
