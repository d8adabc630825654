// SPDX-License-Identifier: Apache-2.0
// Deep pixels: merges the samples of a pixel into a few samples with depth.
#pragma once

#include <vug/image/deep.h>
#include <vug/render/integrator.h>

#include <vector>

namespace vug::render {

struct DeepOptions {
  double tolerance = 0.01;  ///< Surfaces within this relative difference of depth are merged.
  size_t max_samples = 16;  ///< Per pixel; beyond this, the samples closest in depth are merged.
};

/// Accumulates one pixel by depth. Only surfaces have a depth: light scattered by a medium is
/// stored with the surface behind it, and light from the environment, or from a light in front of
/// it, at kDeepSky.
class DeepPixel {
 public:
  explicit DeepPixel(const DeepOptions& options) : options_(options) {}

  /// Adds a sample whose first surface is at this depth. NaN and infinite samples are discarded, as
  /// in PixelSum.
  void add(const PathResult& sample, double depth);
  /// Returns the pixel's samples and resets for the next pixel. Compositing them gives the means of
  /// the added samples: each sample covers its share of the pixel as seen through the samples in
  /// front, so its alpha is that share divided by the share that they leave visible.
  std::vector<image::DeepSample> finish();

 private:
  struct Fragment {
    double near = 0, far = 0, alpha = 0, r = 0, g = 0, b = 0;
    void merge(const Fragment& behind);
  };
  void merge_nearby();

  const DeepOptions options_;
  std::vector<Fragment> fragments_;
  size_t samples_ = 0;
};

inline constexpr double kDeepSky = 1e10;

}  // namespace vug::render
