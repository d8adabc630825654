// Where light comes from, for every place of a scene: bright patches of its surfaces, and how much
// of each is seen from where.
#pragma once

#include <vug/render/guiding/bright_clusters.h>
#include <vug/render/guiding/visibility_cache.h>
#include <vug/render/guiding/cone_mixture.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::render {

/// Patches are to paths what lamps are to direct sampling. A place turns to a patch in proportion
/// to E sqrt(p): E is how much that would light it were nothing between, p the chance that it is
/// in sight (see Chances).
class Guide {
 public:
  /// Knows nothing.
  Guide() = default;
  /// Finds the patches of what was seen in a scene of these bounds; believes each to be in sight
  /// from everywhere.
  Guide(const std::vector<Sighting>& sightings, const Box3f& bounds);
  /// Takes note of what glances tell of the patches.
  void learn(const std::vector<Glance>& glances);

  bool empty() const { return patches_.empty(); }
  const std::vector<BrightPatch>& patches() const { return patches_; }

  /// Directions to turn to from a surface; `normal` on the side that light leaves on.
  Cones at(const Vec3f& point, const Vec3f& normal) const;

 private:
  /// A value for each patch; zeros where there is none.
  struct alignas(32) Row : std::array<float, Cones::kMost> {};

  std::vector<BrightPatch> patches_;
  // Of patches, each value in a row of its own, so that a place weighs eight at a time.
  Row x_{}, y_{}, z_{}, radius_{}, power_{};
  float elsewhere_ = 0;  ///< Irradiance of a usual surface.
  Box3f bounds_;
  Chances chances_;
};

}  // namespace vug::render
