// How often things are in sight, from where: counted region by region.
#pragma once

#include <vug/render/guiding/regions.h>

#include <cstdint>
#include <vector>

namespace vug::render {

/// A look at a thing: from where, at which, and whether it was seen.
struct VisibilitySample {
  Vec3f position{0, 0, 0};
  uint32_t target = 0;
  bool visible = false;
};

/// What visibility_samples tell of a few things, each by its number. GuidingData as in Vevoda,
/// Kondapaneni, Krivanek 2018, "Bayesian online regression for adaptive direct illumination
/// sampling" (vevoda2018bayesian), here by counting: what is seen of a thing from anywhere stands
/// in for a few visibility_samples that a region has not taken.
class VisibilityCache {
 public:
  /// Knows nothing.
  VisibilityCache() = default;
  /// Of `targets`; `edge`: see Regions. The order of visibility_samples does not matter.
  VisibilityCache(const Box3f& bounds, float edge, size_t targets,
                  const std::vector<VisibilitySample>& visibility_samples);

  bool empty() const { return targets_ == 0; }
  /// sqrt(p) of each thing, p the chance that it is in sight from there. Where a thing is in sight
  /// with chance p, and then gives E, choosing it in proportion to E sqrt(p) makes the expected
  /// square of the estimate least: the sum of p E^2 over the share of choices.
  const float* at(const Vec3f& point) const {
    return roots_.data() + targets_ * row_of_[regions_.at(point)];
  }

 private:
  Regions regions_;
  size_t targets_ = 0;
  std::vector<uint32_t> row_of_;  ///< Of each region; 0: none took a glance from there.
  std::vector<float> roots_;      ///< Rows of things.
};

}  // namespace vug::render
