// SPDX-License-Identifier: Apache-2.0
// Guiding towards bright surfaces: the scene's bright clusters, and the visibility of each from
// every region.
#pragma once

#include <vug/render/guiding/bright_clusters.h>
#include <vug/render/guiding/cone_mixture.h>
#include <vug/render/guiding/visibility_cache.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::render {

/// Clusters are to paths what lights are to next-event estimation. A point chooses a cluster in
/// proportion to E sqrt(p), where E is its unoccluded irradiance at the point and p the probability
/// that it is visible (see VisibilityCache).
class Guide {
 public:
  /// Empty guide.
  Guide() = default;
  /// Finds the clusters of the samples in a scene with these bounds; each cluster is assumed to be
  /// visible everywhere.
  Guide(const std::vector<RadianceSample>& radiance_samples, const Box3f& bounds);
  /// Estimates the visibility of the clusters from these samples.
  void update_visibility(const std::vector<VisibilitySample>& visibility_samples);

  /// Calls `each` with every member, for files.
  template <class Self, class Each>
  static void visit(Self& self, const Each& each) {
    each(self.clusters_), each(self.x_), each(self.y_), each(self.z_), each(self.radius_);
    each(self.power_), each(self.elsewhere_), each(self.bounds_), each(self.visibility_);
  }
  /// False if the members contradict each other, as after reading a file that was tampered with.
  bool is_consistent() const {
    return clusters_.size() <= ConeMixture::kMax && visibility_.is_consistent();
  }

  bool empty() const { return clusters_.empty(); }
  const std::vector<BrightCluster>& clusters() const { return clusters_; }

  /// Mixture of directions for a surface point; `normal` is on the side that light leaves on.
  ConeMixture at(const Vec3f& point, const Vec3f& normal) const;

 private:
  /// One value per cluster; unused values are 0.
  struct alignas(32) Values : std::array<float, ConeMixture::kMax> {};

  std::vector<BrightCluster> clusters_;
  // Clusters as structure of arrays, so that eight are weighted at a time.
  Values x_{}, y_{}, z_{}, radius_{}, power_{};
  float elsewhere_ = 0;  ///< Mean irradiance of the scene's surfaces.
  Box3f bounds_;
  VisibilityCache visibility_;
};

}  // namespace vug::render
