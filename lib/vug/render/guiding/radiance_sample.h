// SPDX-License-Identifier: Apache-2.0
// Radiance samples recorded by training paths.
#pragma once

#include <vug/render/vectors.h>

#include <algorithm>
#include <vector>

namespace vug::render {

/// A surface point on a path and the path's estimate of the luminance that it reflects, with the
/// noise of a single path.
struct RadianceSample {
  Vec3f point;
  Vec3f normal;  ///< Geometric, unit, on the path's side.
  float luminance = 0;
  bool first = false;  ///< First surface seen by the camera.
  float indirect = 0;  ///< The part that did not come directly from sampled lights.
};

inline double mean_luminance(const std::vector<RadianceSample>& radiance_samples) {
  double sum = 0;
  for (const RadianceSample& s : radiance_samples) sum += static_cast<double>(s.luminance);
  return sum / static_cast<double>(std::max<size_t>(radiance_samples.size(), 1));
}

}  // namespace vug::render
