// SPDX-License-Identifier: Apache-2.0
// Interface of participating media.
#pragma once

#include <vug/exchange/medium.h>
#include <vug/render/media/tracking.h>
#include <vug/render/vectors.h>
#include <vug/volume/grid.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vug::volume {
class Density;
}

namespace vug::render {

/// A segment of a ray, in metres from its origin; empty if begin >= end.
struct Segment {
  float begin = 0;
  float end = 0;
  bool empty() const { return !(begin < end); }
};

/// Clips the ray up to `end` (may be kFar) to a box.
Segment clip_to_box(const Box3f& box, const Ray& ray, float end);

struct DistanceSample {
  float distance = 0;  ///< From the ray's origin.
  bool scattered = false;
};

/// A point on a ray, in metres from its origin, and the transmittance up to it.
struct ScatterPoint {
  float distance = 0;
  float transmittance = 1;
};

/// A medium for other programs: grids with the names that exchange::Medium gives them.
struct MediumData {
  exchange::Medium medium;
  std::vector<volume::Grid> grids;  ///< The density comes first.
};

/// A medium that fills a region of space; empty outside.
class Medium {
 public:
  virtual ~Medium() = default;
  /// Returns this medium with the scene's box as its region, or null if it has a region of its own.
  virtual std::shared_ptr<const Medium> with_bounds(const Box3f& scene) const = 0;
  /// Returns this medium with the given density, or null if it needs none.
  virtual std::shared_ptr<const Medium> with_density(
      std::shared_ptr<const volume::Density> density) const {
    (void)density;
    return nullptr;
  }
  /// It is defined by grids, those of a volume or of a file.
  virtual bool has_grids() const { return false; }
  /// Description for other programs, once the medium has a density. `density` is that of the volume
  /// which the medium is declared on, null if the medium has its own. Empty for media that no grid
  /// can describe.
  virtual std::optional<MediumData> as_data(const volume::Grid* density) const {
    return (void)density, std::nullopt;
  }
  /// It has no density yet.
  virtual bool needs_density() const { return false; }
  /// Clips the ray up to `end` (may be kFar) to the medium.
  virtual Segment clip(const Ray& ray, float end) const = 0;
  /// Transmittance of a segment: exact, or an unbiased estimate.
  virtual float transmittance(const Ray& ray, const Segment& segment,
                              TrackingRng& numbers) const = 0;
  /// Samples a distance in proportion to the density of the first collision. It also sets the
  /// transmittance of the scatter points, which are inside the segment: unbiased, but correlated
  /// with the distance and with each other.
  virtual DistanceSample sample_distance(const Ray& ray, const Segment& segment, float u,
                                         std::span<ScatterPoint> scatter_points,
                                         TrackingRng& numbers) const = 0;
  DistanceSample sample_distance(const Ray& ray, const Segment& segment, float u,
                                 TrackingRng& numbers) const {
    return sample_distance(ray, segment, u, {}, numbers);
  }
  /// Extinction coefficient in 1/m; `albedo` is the fraction of collisions that scatter.
  virtual float extinction(const Vec3f& point) const = 0;
  /// Prefetches the data that `extinction` reads at the point.
  virtual void prefetch(const Vec3f& point) const { (void)point; }
  virtual Rgb albedo(const Vec3f& point) const = 0;
  /// Representative extinction coefficient in 1/m, for sampling along rays.
  virtual float typical_extinction() const = 0;
  /// Emission of the dense medium: multiplied by the extinction, the radiance added per metre.
  virtual Rgb emission(const Vec3f& point) const { return (void)point, Rgb(0.0f); }
  /// It also emits independently of its density: flames.
  virtual bool is_emissive() const { return false; }
  /// Unbiased estimate of that emission over a segment, as it arrives at the ray's origin.
  virtual Rgb sample_emission(const Ray& ray, const Segment& segment, TrackingRng& numbers) const {
    (void)ray, (void)segment, (void)numbers;
    return Rgb(0.0f);
  }

  /// Phase function of the cosine between the two directions of travel, in 1/sr; integrates to 1.
  virtual float phase(float cosine) const = 0;
  /// Samples a new direction of travel with density `phase`.
  virtual Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const = 0;
};
using MediumPtr = std::shared_ptr<const Medium>;

}  // namespace vug::render
