// How much light surfaces send back: region by region, and by the way they face.
#pragma once

#include <vug/render/guiding/radiance_sample.h>
#include <vug/render/guiding/regions.h>

#include <cstddef>
#include <vector>

namespace vug::render {

/// What the surfaces of a region that face the same way send back, in luminance.
struct RadianceStats {
  float mean = 0;  ///< The mean, but no more than that of what the camera sees.
  float indirect =
      0;  ///< The root of the mean square of what the path has yet to find: see RadianceSample.
};

class RadianceCache {
 public:
  /// Knows nothing.
  RadianceCache() = default;
  /// `edge`: see Regions.
  RadianceCache(const std::vector<RadianceSample>& radiance_samples, const Box3f& bounds,
                float edge);

  /// The mean absolute distance of what single paths of the camera find from the mean of its place,
  /// in parts of that, squared; at most 1. As a variance, but single bright paths do not rule it.
  float noise() const { return noise_; }
  bool empty() const { return stats_.empty(); }
  /// Not of an empty one.
  const RadianceStats& at(const Vec3f& point, const Vec3f& normal) const {
    return stats_[place(point, normal)];
  }

 private:
  static constexpr size_t kFacings = 6;
  size_t place(const Vec3f& point, const Vec3f& normal) const {
    return kFacings * regions_.at(point) + facing(normal);
  }
  /// The side of a cube that a normal is nearest to.
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
