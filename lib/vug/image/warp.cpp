#include <vug/base/error.h>
#include <vug/image/warp.h>

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>

namespace vug::image {

Image warped(const Image& picture, const Homography& to_target, int width, int height) {
  Image out(width, height, picture.channels);
  const auto channels = static_cast<int>(picture.channels.size());
  const auto spec = [&](int w, int h) {
    return OIIO::ImageSpec(w, h, channels, OIIO::TypeDesc::FLOAT);
  };
  // A read-only buffer around our pixels.
  const OIIO::ImageBuf from(spec(picture.width, picture.height),
                            const_cast<float*>(picture.pixels.data()));
  OIIO::ImageBuf to(spec(width, height), out.pixels.data());
  // Imath uses row vectors.
  Imath::M33f matrix;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      matrix[column][row] = static_cast<float>(to_target.m[static_cast<size_t>(3 * row + column)]);
  const OIIO::ROI all(0, width, 0, height, 0, 1, 0, channels);
  if (!OIIO::ImageBufAlgo::warp(to, from, matrix, "lanczos3", 6, false, OIIO::ImageBuf::WrapBlack,
                                all))
    throw Error(ErrorCode::internal, "resampling of the image failed: " + to.geterror());
  const auto count = static_cast<size_t>(channels);
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
