// SPDX-License-Identifier: Apache-2.0
// The input of the denoiser as planes: light, its variance, and the features that guide the filter.
#pragma once

#include <vug/image/image.h>

#include <vector>

namespace vug::image {

/// One value per pixel.
using PixelValues = std::vector<float>;

struct DenoiseInputs {
  int width = 0, height = 0;
  PixelValues colour[3], variance[3],
      albedo[3];                      ///< Colour and variance are those of light / albedo.
  std::vector<PixelValues> features;  ///< Scaled such that a difference of 1 is an edge.

  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
};

/// Reads the layers, limits outliers (denoise_outliers.h), and raises the variance of each pixel to
/// that of its neighbourhood, because single variances are noisy themselves, and too small where
/// the paths that matter have not been sampled yet. Error(bad_input) if a layer is missing.
DenoiseInputs denoise_inputs(const Image& picture);

}  // namespace vug::image
