// The seam of media: what the air does to light between surfaces.
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

/// A part of a ray, in metres from its origin; empty when begin >= end.
struct Segment {
  float begin = 0;
  float end = 0;
  bool empty() const { return !(begin < end); }
};

/// The part of a ray before `end` (may be kFar) that lies in a box.
Segment clip_to_box(const Box3f& box, const Ray& ray, float end);

struct DistanceSample {
  float distance = 0;  ///< From the ray's origin.
  bool scattered = false;
};

/// A place on a ray, in metres from its origin, and the part of the light that comes through to it.
struct ScatterPoint {
  float distance = 0;
  float transmittance = 1;
};

/// A cloud for other programs: grids with the names that exchange::Medium has for them.
struct CloudData {
  exchange::Medium medium;
  std::vector<volume::Grid> grids;  ///< The density first.
};

/// Fills a region of space; clear air outside it.
class Medium {
 public:
  virtual ~Medium() = default;
  /// This medium with its region set to the scene's box, when it was given no region of its own;
  /// null when it has one.
  virtual std::shared_ptr<const Medium> with_bounds(const Box3f& scene) const = 0;
  /// This medium with its density told; null when it needs none.
  virtual std::shared_ptr<const Medium> with_density(
      std::shared_ptr<const volume::Density> density) const {
    (void)density;
    return nullptr;
  }
  /// It is what grids tell, those of a volume or of a file.
  virtual bool has_grids() const { return false; }
  /// What other programs are told of it once it is not hollow; `density` is that of the volume it
  /// stands on, null for one that has its own. Nothing of media that no grid can tell.
  virtual std::optional<CloudData> as_data(const volume::Grid* density) const {
    return (void)density, std::nullopt;
  }
  /// It has no density yet.
  virtual bool needs_density() const { return false; }
  /// The part of the ray before `end` (may be kFar) that lies in the medium.
  virtual Segment clip(const Ray& ray, float end) const = 0;
  /// Part of the light that comes through a segment: exact, or an estimate whose mean it is.
  virtual float transmittance(const Ray& ray, const Segment& segment,
                              TrackingRng& numbers) const = 0;
  /// A distance with the density of the first collision. By the way the marks, which lie in the
  /// segment, are told what `transmittance` would be to them: right in the mean, not independent of
  /// the distance and of each other.
  virtual DistanceSample sample_distance(const Ray& ray, const Segment& segment, float u,
                                         std::span<ScatterPoint> scatter_points,
                                         TrackingRng& numbers) const = 0;
  DistanceSample sample_distance(const Ray& ray, const Segment& segment, float u,
                                 TrackingRng& numbers) const {
    return sample_distance(ray, segment, u, {}, numbers);
  }
  /// Collisions per metre, and which part of the light they scatter instead of swallowing.
  virtual float extinction(const Vec3f& point) const = 0;
  /// Calls from memory what `extinction` will ask for there.
  virtual void prefetch(const Vec3f& point) const { (void)point; }
  virtual Rgb albedo(const Vec3f& point) const = 0;
  /// Collisions per metre as a round number, to share samples out along rays.
  virtual float typical_extinction() const = 0;
  /// What the medium sends out by itself where it is dense: times the extinction, radiance that is
  /// added per metre.
  virtual Rgb emission(const Vec3f& point) const { return (void)point, Rgb(0.0f); }
  /// It also shines where its density does not tell: flames.
  virtual bool is_emissive() const { return false; }
  /// That light over a segment as it arrives at the ray's origin: an estimate whose mean it is.
  virtual Rgb sample_emission(const Ray& ray, const Segment& segment, TrackingRng& numbers) const {
    (void)ray, (void)segment, (void)numbers;
    return Rgb(0.0f);
  }

  /// Phase function over the angle between the two directions of travel, in 1/sr; integrates to 1.
  virtual float phase(float cosine) const = 0;
  /// A new direction of travel with density `phase`.
  virtual Vec3f sample_phase(const Vec3f& travel, const Vec2f& u) const = 0;
};
using MediumPtr = std::shared_ptr<const Medium>;

}  // namespace vug::render
