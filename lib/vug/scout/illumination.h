// SPDX-License-Identifier: Apache-2.0
// An estimate of the light in a view: direct light, and light that was reflected once.
#pragma once

#include <vug/base/rng.h>
#include <vug/image/image.h>
#include <vug/render/prepared_scene.h>
#include <vug/scout/view.h>

namespace vug::scout {

struct IlluminationOptions {
  int rays = 1;  ///< Reflected rays of each pixel.
};

/// Luminance of each pixel, W/(m^2 sr): emission, and Lambertian reflection of the light of
/// `lights` at the first surface and, by `rays` random directions, at the second. Skies and
/// emissive surfaces shine through the reflected rays. Light that was reflected more often is left
/// out, so that the true picture is brighter. Unbiased but for this; the same for any number of
/// threads.
std::vector<float> illuminate(const render::PreparedScene& world,
                              const std::vector<render::LightPtr>& lights, const View& view,
                              RandomKey key, const IlluminationOptions& options = {});

/// Luminances as a picture of one row, for the functions of image/brightness.h.
image::Image grey_picture(const std::vector<float>& luminance);

/// The lit picture as a judge of exposures.
struct LightTerms {
  double stops = 0;   ///< The metered exposure; 0 without light.
  double black = 1;   ///< Share of the pixels below 0.004 at that exposure.
  double bright = 0;  ///< The 99th percentile at that exposure.
  /// Length of the edges at which a dark surface is seen in front of one that is at least four
  /// times as bright and visible at that exposure, relative to the width of the picture.
  double silhouettes = 0;

  /// At most 1: the factor of the blacks, which is 1 if up to half of the picture is black and 0
  /// if 85 % are, times 0.7 without silhouettes and 1 if they are at least half as long as the
  /// picture is wide.
  double total() const;
};
LightTerms light_terms(const std::vector<float>& luminance, const View& view);

}  // namespace vug::scout
