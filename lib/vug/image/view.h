// SPDX-License-Identifier: Apache-2.0
// Conversion from scene-linear light to display values by exposure and tone curve.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/image/image.h>

#include <memory>

namespace vug::image {

enum class ViewTransform {
  filmic,  ///< ACES-like curve with toe and shoulder, fitted by Hill (cite hill2017aces).
  srgb,    ///< Clipping to [0, 1] only, for data and for comparison.
};

class OcioView;

struct ViewOptions {
  double exposure = 0;  ///< In stops: the light is multiplied by 2^exposure first.
  ViewTransform transform = ViewTransform::filmic;
  WorkingSpace space = WorkingSpace::rec709;  ///< Working space of the light.
  /// A view of an OpenColorIO configuration instead of `transform`; see ocio_view.h.
  std::shared_ptr<const OcioView> ocio = nullptr;
  bool dither =
      true;  ///< Ordered dither of +-1/2 code value against banding in dark gradients (8 bit).
};

/// For images that are not light, such as labels, masks and charts: sRGB without dither.
ViewOptions plain_view();

/// Display-referred R, G, B in [0, 1] with the transfer function of the display (sRGB unless a
/// configuration specifies another); other channels are dropped. An image with a single channel and
/// no R, G, B is shown as grey. NaN is shown as black.
Image display(const Image& linear, const ViewOptions& options = {});

/// Converts R, G and B, if present, to linear Rec.709.
Image in_rec709(Image picture, WorkingSpace space);

}  // namespace vug::image
