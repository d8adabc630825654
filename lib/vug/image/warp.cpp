// SPDX-License-Identifier: Apache-2.0
#include <vug/image/backend.h>

#include <algorithm>

namespace vug::image {

Image warped(const Image& picture, const Homography& to_target, int width, int height) {
  Image out(width, height, picture.channels);
  backend().warp(picture, to_target, out);
  const auto count = picture.channels.size();
  for (size_t c = 0; c < count; ++c) {
    float least = 0;
    for (size_t i = c; i < picture.pixels.size(); i += count)
      least = std::min(least, picture.pixels[i]);
    for (size_t i = c; i < out.pixels.size(); i += count)
      if (least >= 0) out.pixels[i] = std::max(out.pixels[i], 0.0F);
  }
  return out;
}

}  // namespace vug::image
