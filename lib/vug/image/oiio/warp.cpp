// SPDX-License-Identifier: Apache-2.0
// Resampling of pictures by a homography with OpenImageIO.
#include <vug/base/error.h>
#include <vug/image/backend.h>

#include <OpenImageIO/imagebufalgo.h>

namespace vug::image::oiio {

void warp(const Image& picture, const Homography& to_target, Image& out) {
  const auto channels = static_cast<int>(picture.channels.size());
  const auto spec = [&](int w, int h) {
    return OIIO::ImageSpec(w, h, channels, OIIO::TypeDesc::FLOAT);
  };
  // A read-only buffer around our pixels.
  const OIIO::ImageBuf from(spec(picture.width, picture.height),
                            const_cast<float*>(picture.pixels.data()));
  OIIO::ImageBuf to(spec(out.width, out.height), out.pixels.data());
  // Imath uses row vectors.
  Imath::M33f matrix;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      matrix[column][row] = static_cast<float>(to_target.m[static_cast<size_t>(3 * row + column)]);
  const OIIO::ROI all(0, out.width, 0, out.height, 0, 1, 0, channels);
  if (!OIIO::ImageBufAlgo::warp(to, from, matrix, "lanczos3", 6, false, OIIO::ImageBuf::WrapBlack,
                                all))
    throw Error(ErrorCode::internal, "resampling of the image failed: " + to.geterror());
}

}  // namespace vug::image::oiio
