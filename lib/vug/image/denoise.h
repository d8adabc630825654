// SPDX-License-Identifier: Apache-2.0
// Denoising of a rendered image with the help of its feature layers, for previews.
#pragma once

#include <vug/base/progress.h>
#include <vug/image/image.h>

#include <string>
#include <vector>

namespace vug::image {

struct DenoiseOptions {
  int window = 10;        ///< Radius of the round search window, pixels.
  double deviation = 6;   ///< Standard deviation of the weight by distance, pixels.
  int patch = 2;          ///< Radius of the compared patches, pixels.
  double strength = 0.8;  ///< Differences below this number of standard errors count as noise.
};

/// The layers that denoise uses in addition to the beauty: albedo, N, Z and variance.
const std::vector<std::string>& denoising_layers();

/// Non-local regression of R, G, B: pixels are weighted by the colour distance in units of its
/// variance and, jointly, by albedo, normal and depth (Rousselle, Manzi and Zwicker 2013, "Robust
/// denoising using feature and color information", cite rousselle2013denoising). Differences
/// from the paper: one scale instead of three candidates, filtering of light without the albedo if
/// there is an albedo layer, a polynomial instead of the exponential, outliers limited beforehand
/// (denoise_outliers.h), a weight that falls with distance, a limit on the ratio of variances, and
/// a linear regression over position and features in place of the weighted mean, as in Bitterli and
/// others 2016, "Nonlinearly weighted first-order regression for denoising Monte Carlo renderings"
/// (cite bitterli2016nfor): shading that follows the features keeps its contrast.
/// The image needs R, G, B and variance.R .G .B; albedo, N and Z are used if present. The filter is
/// biased: it smooths features that no layer distinguishes, such as the edges of soft shadows.
/// Throws Error(bad_input) if a required channel is missing. The result has the channels
/// denoised.R, denoised.G, denoised.B and the same bytes for any number of threads.
Image denoise(const Image& picture, const DenoiseOptions& options = {},
              Progress& progress = Progress::none());

}  // namespace vug::image
