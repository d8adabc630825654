// SPDX-License-Identifier: Apache-2.0
// Luminance reflected by surfaces, by region and by the direction they face.
#pragma once

#include <vug/render/guiding/radiance_sample.h>
#include <vug/render/guiding/regions.h>

#include <cstddef>
#include <vector>

namespace vug::render {

/// Reflected luminance of the surfaces of a region that face the same way.
struct RadianceStats {
  float mean = 0;  ///< Mean, clamped to the mean of the surfaces that the camera sees.
  float indirect =
      0;  ///< Root mean square of the light that the path has yet to find: see RadianceSample.
};

class RadianceCache {
 public:
  /// Empty cache.
  RadianceCache() = default;
  /// `edge`: see Regions.
  RadianceCache(const std::vector<RadianceSample>& radiance_samples, const Box3f& bounds,
                float edge);

  /// Calls `each` with every member, for files.
  template <class Self, class Each>
  static void visit(Self& self, const Each& each) {
    each(self.regions_), each(self.stats_), each(self.noise_);
  }
  /// False if the members contradict each other, as after reading a file that was tampered with.
  bool is_consistent() const { return empty() || stats_.size() == kFacings * regions_.count(); }

  /// Squared relative mean absolute deviation of single camera paths from the mean of their region,
  /// at most 1. It stands in for the variance, but is robust against single bright paths.
  float noise() const { return noise_; }
  bool empty() const { return stats_.empty(); }
  /// Must not be called on an empty cache.
  const RadianceStats& at(const Vec3f& point, const Vec3f& normal) const {
    return stats_[place(point, normal)];
  }

 private:
  static constexpr size_t kFacings = 6;
  size_t place(const Vec3f& point, const Vec3f& normal) const {
    return kFacings * regions_.at(point) + facing(normal);
  }
  /// The side of a cube closest to a normal.
  static size_t facing(const Vec3f& normal) {
    const float x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    if (x >= y && x >= z) return normal.x < 0 ? 0 : 1;
    if (y >= z) return normal.y < 0 ? 2 : 3;
    return normal.z < 0 ? 4 : 5;
  }

  Regions regions_;
  std::vector<RadianceStats> stats_;
  float noise_ = 0;
};

}  // namespace vug::render
