// Where samples are gathered: sums for each pixel that any number of threads, passes or machines
// may fill in any order, and get the same bits.
#pragma once

#include <vug/image/image.h>
#include <vug/render/camera.h>
#include <vug/render/fixed.h>
#include <vug/render/integrator.h>

#include <array>

namespace vug::render {

/// Names of the channels in the order of `render`.
const std::vector<std::string>& layer_names();

/// The sums of one pixel. Each sample counts for its pixel alone and for all of it (box filter).
/// Sums are integers: `add` in any order and `merge` of any split give the same bits.
struct PixelSum {
  std::array<Wide, 3> light{}, square{};  ///< Radiance and its square, in 2^-64 and 2^-48.
  std::array<int64_t, 3> normal{}, position{}, albedo{};  ///< Of the first surface, in 2^-24.
  int64_t alpha = 0, depth = 0;                           ///< In 2^-24.
  uint32_t samples = 0;                                   ///< That the means are over.
  uint32_t hits = 0;     ///< Of these, those whose ray met a surface.
  uint32_t refused = 0;  ///< Samples with a radiance that is no number: left out of everything.
  uint32_t cut = 0;      ///< Samples brighter than kMostLight, cut to it.

  void add(const PathResult& sample, const Camera& camera);
  void merge(const PixelSum& other);
  /// Mean radiance of a channel 0..2, and the variance of that mean (its squared standard error),
  /// from the spread of the samples; 0 for fewer than two samples.
  double mean(size_t channel) const;
  double variance(size_t channel) const;
  /// Writes the means into a pixel of an image with the channels of layer_names().
  void store(image::Image& image, int x, int y) const;

  bool operator==(const PixelSum&) const = default;
};

}  // namespace vug::render
