// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/log2.h>
#include <vug/base/srgb.h>
#include <vug/image/colour_channels.h>
#include <vug/image/ocio_view.h>
#include <vug/image/view.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::image {
namespace {

using Colour = std::array<double, 3>;

Colour multiplied_by(const double (&m)[3][3], const Colour& c) {
  Colour out{};
  for (size_t i = 0; i < 3; ++i) out[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
  return out;
}

// Matrices and rational rational_curve: S. Hill's fit of the ACES 1.0 reference rendering and sRGB
// output transforms. The matrices include Rec.709 <-> AP1, D65 <-> D60 and the desaturations at
// both ends (hill2017aces).
constexpr double kToCurve[3][3] = {
    {0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}};
constexpr double kFromCurve[3][3] = {
    {1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605}, {-0.00327, -0.07276, 1.07602}};

double rational_curve(double v) {
  return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
}

Colour filmic(Colour c) {
  c = multiplied_by(kToCurve, c);
  for (double& v : c) v = rational_curve(v);
  return multiplied_by(kFromCurve, c);
}

}  // namespace

ViewOptions plain_view() {
  ViewOptions plain;
  plain.transform = ViewTransform::srgb;
  plain.dither = false;
  return plain;
}

Image in_rec709(Image picture, WorkingSpace space) {
  const ColourMatrix to_rec709(space, WorkingSpace::rec709);
  const std::optional<Channels> channels = colour_channels(picture);
  if (to_rec709.is_identity() || !channels) return picture;
  for (size_t p = 0; p < picture.pixel_count(); ++p) {
    const Vec3f c(to_rec709(colour_at(picture, p, *channels)));
    for (size_t i = 0; i < 3; ++i)
      picture.pixels[p * picture.channels.size() + (*channels)[i]] = c[static_cast<int>(i)];
  }
  return picture;
}

Image display(const Image& linear, const ViewOptions& options) {
  std::optional<Channels> from = colour_channels(linear);
  if (!from) {
    if (linear.channels.size() != 1)
      throw Error(ErrorCode::bad_input, "displaying an image requires the channels R, G and B");
    from = Channels{0, 0, 0};
  }
  const double gain = maths::exp2(options.exposure);
  Image out(linear.width, linear.height, {"R", "G", "B"});
  if (options.ocio) {
    for (size_t p = 0; p < linear.pixel_count(); ++p) {
      const Vec3d c = colour_at(linear, p, *from) * gain;
      // Colours outside the space have negative components, which a configuration can handle.
      for (size_t i = 0; i < 3; ++i) {
        const double v = c[static_cast<int>(i)];
        out.pixels[p * 3 + i] =
            std::isnan(v) ? 0 : static_cast<float>(std::clamp(v, -kBrightest, kBrightest));
      }
    }
    options.ocio->apply(out.pixels.data(), out.pixel_count());
    for (float& v : out.pixels) v = v > 0 ? std::min(v, 1.0f) : 0;
    return out;
  }
  const ColourMatrix to_rec709(options.space, WorkingSpace::rec709);
  for (size_t p = 0; p < linear.pixel_count(); ++p) {
    const Vec3d light = to_rec709(colour_at(linear, p, *from));
    Colour c = {light.x, light.y, light.z};
    for (double& v : c) v = displayable(gain * v);
    if (options.transform == ViewTransform::filmic) c = filmic(c);
    for (size_t i = 0; i < 3; ++i) out.pixels[p * 3 + i] = static_cast<float>(srgb_encode(c[i]));
  }
  return out;
}

}  // namespace vug::image
