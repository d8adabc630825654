// SPDX-License-Identifier: Apache-2.0
// Planes with one number per pixel, and separable filters.
#pragma once

#include <vug/image/image.h>

#include <vector>

namespace vug::image {

/// Row by row from the top. Stored as float, computed as double.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// An odd number of weights; the middle one belongs to the pixel itself.
using Kernel = std::vector<double>;

/// exp(-x^2 / (2 sigma^2)) for |x| <= radius, scaled to a sum of 1; sigma in pixels.
Kernel gaussian(double sigma, int radius);

/// out(x, y) = sum of across[i] down[j] in(x + i, y + j), i and j from -radius to radius. Pixels
/// beyond the border have the value of the nearest pixel.
Plane filtered(const Plane& in, const Kernel& across, const Kernel& down);

/// One channel of a picture.
Plane plane_of(const Image& image, size_t channel);

}  // namespace vug::image
