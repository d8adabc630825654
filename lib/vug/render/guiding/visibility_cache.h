// SPDX-License-Identifier: Apache-2.0
// Visibility of lights or clusters, estimated region by region.
#pragma once

#include <vug/render/guiding/regions.h>

#include <cstdint>
#include <vector>

namespace vug::render {

/// A visibility test: from which position, of which target, and whether the target was visible.
struct VisibilitySample {
  Vec3f position{0, 0, 0};
  uint32_t target = 0;
  bool visible = false;
};

/// Estimated visibility of a few targets, which are identified by index. Learned as in Vevoda,
/// Kondapaneni, Krivanek 2018, "Bayesian online regression for adaptive direct illumination
/// sampling" (vevoda2018bayesian), here by counting: the visibility of a target over all regions
/// counts as a few prior samples in each region.
class VisibilityCache {
 public:
  /// Empty cache.
  VisibilityCache() = default;
  /// For `targets` targets; `edge`: see Regions. The order of the samples does not matter.
  VisibilityCache(const Box3f& bounds, float edge, size_t targets,
                  const std::vector<VisibilitySample>& visibility_samples);

  /// Calls `each` with every member, for files.
  template <class Self, class Each>
  static void visit(Self& self, const Each& each) {
    each(self.regions_), each(self.targets_), each(self.row_of_), each(self.roots_);
  }
  /// False if the members contradict each other, as after reading a file that was tampered with.
  bool is_consistent() const;

  bool empty() const { return targets_ == 0; }
  /// sqrt(p) for each target, where p is the probability that it is visible from the point. If a
  /// target is visible with probability p and then contributes E, choosing it in proportion to E
  /// sqrt(p) minimizes the second moment of the estimate: the sum of p E^2 over the probability of
  /// the choice.
  const float* at(const Vec3f& point) const {
    return roots_.data() + targets_ * row_of_[regions_.at(point)];
  }

 private:
  Regions regions_;
  size_t targets_ = 0;
  std::vector<uint32_t> row_of_;  ///< For each region; 0: no samples there.
  std::vector<float> roots_;      ///< Rows of one value per target.
};

}  // namespace vug::render
