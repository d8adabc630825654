// Where light comes from, for every place of a scene: bright patches of its surfaces, and how much
// of each is seen from where.
#pragma once

#include <vug/render/guiding/bright_clusters.h>
#include <vug/render/guiding/cone_mixture.h>
#include <vug/render/guiding/visibility_cache.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::render {

/// Patches are to paths what lamps are to direct sampling. A place turns to a patch in proportion
/// to E sqrt(p): E is how much that would light it were nothing between, p the chance that it is
/// in sight (see VisibilityCache).
class Guide {
 public:
  /// Knows nothing.
  Guide() = default;
  /// Finds the patches of what was seen in a scene of these bounds; believes each to be in sight
  /// from everywhere.
  Guide(const std::vector<RadianceSample>& radiance_samples, const Box3f& bounds);
  /// Takes note of what visibility_samples tell of the patches.
  void update_visibility(const std::vector<VisibilitySample>& visibility_samples);

  bool empty() const { return clusters_.empty(); }
  const std::vector<BrightCluster>& clusters() const { return clusters_; }

  /// Directions to turn to from a surface; `normal` on the side that light leaves on.
  ConeMixture at(const Vec3f& point, const Vec3f& normal) const;

 private:
  /// A value for each patch; zeros where there is none.
  struct alignas(32) Values : std::array<float, ConeMixture::kMax> {};

  std::vector<BrightCluster> clusters_;
  // Of patches, each value in a row of its own, so that a place weighs eight at a time.
  Values x_{}, y_{}, z_{}, radius_{}, power_{};
  float elsewhere_ = 0;  ///< Irradiance of a usual surface.
  Box3f bounds_;
  VisibilityCache visibility_;
};

}  // namespace vug::render
