// SPDX-License-Identifier: Apache-2.0
// Statistics about the luminance of images, and exposures that follow from them.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/image/image.h>

#include <optional>

namespace vug::image {

/// The fraction of pixels whose luminance exceeds `luminance`; 0 for images without R, G and B.
double fraction_above(const Image& linear, double luminance,
                      WorkingSpace space = WorkingSpace::rec709);

/// The exposure in stops at which the log-average luminance of the pixels with light becomes middle
/// grey, 0.18 (reinhard2002). None for an image without R, G, B or without light.
std::optional<double> grey_exposure(const Image& linear, WorkingSpace space = WorkingSpace::rec709);

/// The exposure in stops of a photographer who leaves dark parts dark, since most of a cave is, but
/// not the whole cave behind a bright mouth. Surfaces are the pixels with an alpha of at least one
/// half, or all pixels without an alpha channel, and where surfaces cover less than 5 % of the
/// picture.
///   - The lit surfaces are those above a sixteenth of the 90th percentile of the surfaces. Their
///     median becomes 0.16, slightly below middle grey.
///   - The 99.5th percentile of all pixels becomes at most 6, which the filmic curve still shows
///     with colour, so that a lamp or the sky in the picture reduces the exposure,
///   - but no further than to where the median of the surfaces is 0.06, which is dark but not
///   black.
///     Those below a thousandth of the 90th percentile do not count, because no light reaches them.
///   - If less than 30 % of the surfaces are lit, a sunbeam at the mouth for instance, that median
///     also raises the exposure, by up to 5 stops, as long as at most 5 % of the surfaces are above
///     3 and 2 % above 8.
/// None for an image without R, G, B or without light.
std::optional<double> metered_exposure(const Image& linear,
                                       WorkingSpace space = WorkingSpace::rec709);

}  // namespace vug::image
