// Planes of numbers, one for each pixel, and separable filters over them.
#pragma once

#include <vug/image/image.h>

#include <vector>

namespace vug::image {

/// Row by row from the top. Values are kept as float and computed as double.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// An odd number of weights, the middle one for the pixel itself.
using Kernel = std::vector<double>;

/// exp(-x^2 / (2 sigma^2)) for |x| <= radius, scaled to a sum of 1; sigma in pixels.
Kernel gaussian(double sigma, int radius);

/// out(x, y) = sum of across[i] down[j] in(x + i, y + j), i and j from -radius to radius; beyond
/// the border the nearest pixel stands.
Plane filtered(const Plane& in, const Kernel& across, const Kernel& down);

/// One channel of a picture.
Plane plane_of(const Image& image, size_t channel);

}  // namespace vug::image
