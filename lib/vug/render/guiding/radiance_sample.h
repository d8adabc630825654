// What paths tell of the surfaces they come by.
#pragma once

#include <vug/render/vectors.h>

#include <algorithm>
#include <vector>

namespace vug::render {

/// A surface that a path came to, and how bright the path found it: an estimate of the luminance
/// that it sends back, as noisy as one path is.
struct RadianceSample {
  Vec3f point;
  Vec3f normal;  ///< Geometric, unit, on the path's side.
  float luminance = 0;
  bool first = false;  ///< The camera sees it.
  float indirect = 0;  ///< The part of it that did not come straight from lights that were chosen.
};

inline double mean_luminance(const std::vector<RadianceSample>& radiance_samples) {
  double sum = 0;
  for (const RadianceSample& s : radiance_samples) sum += static_cast<double>(s.luminance);
  return sum / static_cast<double>(std::max<size_t>(radiance_samples.size(), 1));
}

}  // namespace vug::render
