// Where light comes from, for every place of a scene: bright patches of its surfaces, and how much
// of each is seen from where.
#pragma once

#include <vug/render/guiding/bright_patches.h>
#include <vug/render/guiding/cones.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::render {

/// A look at a patch: from where, at which, and whether the ray got there.
struct Glance {
  Vec3f from;
  uint32_t patch = 0;
  bool reached = false;
};

/// Patches are to paths what lamps are to direct sampling. A place turns to a patch in proportion
/// to E sqrt(p): E is how much that would light it were nothing between, p the part of glances from
/// the place's region that got there. Where a patch is in sight with chance p, and then gives E,
/// that share a makes the expected square of the estimate, the sum of p E^2 / a, least.
///
/// p is learned, as in Vevoda, Kondapaneni, Krivanek 2018, "Bayesian online regression for adaptive
/// direct illumination sampling" (vevoda2018bayesian), here by counting: what is seen of a patch
/// from anywhere stands in for a few glances that its region has not taken.
class Guide {
 public:
  /// Knows nothing.
  Guide() = default;
  /// Finds the patches of what was seen in a scene of these bounds; believes each to be in sight
  /// from everywhere.
  Guide(const std::vector<Sighting>& sightings, const Box3f& bounds);
  /// The same patches, and what glances tell of them. The order of these does not matter.
  Guide(const Guide& patches, const std::vector<Glance>& glances);

  bool empty() const { return patches_.empty(); }
  const std::vector<BrightPatch>& patches() const { return patches_; }

  /// Directions to turn to from a surface; `normal` on the side that light leaves on.
  Cones at(const Vec3f& point, const Vec3f& normal) const;

 private:
  using Row = std::array<float, Cones::kMost>;  ///< A value for each patch.
  size_t region(const Vec3f& point) const;

  std::vector<BrightPatch> patches_;
  // Of patches, each value in a row of its own, so that a place weighs eight at a time.
  Row x_{}, y_{}, z_{}, radius_{}, power_{};
  float elsewhere_ = 0;  ///< Irradiance of a usual surface.
  Box3f bounds_;
  float regions_per_metre_ = 1;
  std::array<int, 3> regions_{1, 1, 1};
  std::vector<uint32_t> row_of_{0};  ///< Of each region; 0: none took a glance from there.
  std::vector<Row> chance_{Row{}};   ///< sqrt(p).
};

}  // namespace vug::render
