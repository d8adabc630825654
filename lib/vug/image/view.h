// From scene-linear light to display values.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/image/image.h>

#include <memory>
#include <optional>

namespace vug::image {

enum class ViewTransform {
  filmic,  ///< ACES-like curve with toe and shoulder, fitted by Hill (cite hill2017aces).
  srgb,    ///< Only clipped to [0, 1]: for data and for comparison.
};

class OcioView;

struct ViewOptions {
  double exposure = 0;  ///< In stops: the light is multiplied by 2^exposure first.
  ViewTransform transform = ViewTransform::filmic;
  WorkingSpace space = WorkingSpace::rec709;  ///< That the light is in.
  /// A view of an OpenColorIO configuration instead of `transform`; see configured_view.h.
  std::shared_ptr<const OcioView> ocio = nullptr;
  bool dither = true;  ///< A fixed +-1/2 code pattern against bands in dark gradients (8 bit).
};

/// For pictures that are no light, as labels, masks and charts: sRGB without dither.
ViewOptions plain_view();

/// Display-referred R, G, B in [0, 1] with the transfer function of the display (sRGB's unless a
/// configuration says otherwise); other channels dropped.
/// A picture without R, G, B but one channel is shown as grey. NaN shows as black.
Image display(const Image& linear, const ViewOptions& options = {});

/// The picture with R, G and B, where it has them, turned to linear Rec.709.
Image in_rec709(Image picture, WorkingSpace space);

/// The exposure, in stops, at which the log-average luminance of the pixels that light reaches is
/// middle grey, 0.18 (reinhard2002). None for a picture without R, G, B or without light.
std::optional<double> grey_exposure(const Image& linear, WorkingSpace space = WorkingSpace::rec709);

/// sRGB transfer function (IEC 61966-2-1) and its inverse, for values in [0, 1].
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace vug::image
