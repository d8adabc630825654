// Gathers what a pixel's samples meet at which depth into a few samples of a deep picture.
#pragma once

#include <vug/image/deep.h>
#include <vug/render/integrator.h>

#include <vector>

namespace vug::render {

struct DeepOptions {
  double tolerance = 0.01;  ///< Surfaces this far apart, as a part of their depth, are one.
  size_t max_samples = 16;  ///< Samples of a pixel; more are put together where they are nearest.
};

/// One pixel's light by depth. Only surfaces have a place: what the air before them scatters comes
/// with the surface behind it, what comes from the sky or a lamp before it lies at kDeepSky.
class DeepPixel {
 public:
  explicit DeepPixel(const DeepOptions& options) : options_(options) {}

  /// A sample whose first surface lies at that depth. Samples that are no numbers are left out, as
  /// in PixelSum.
  void add(const PathResult& sample, double depth);
  /// The pixel, and ready for the next. Compositing it gives the means of what was added: each
  /// sample hides its share of the pixel, seen through those before it, so its alpha is that
  /// share over what these leave.
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
