// How often things are in sight, from where: counted region by region.
#pragma once

#include <vug/render/guiding/regions.h>

#include <cstdint>
#include <vector>

namespace vug::render {

/// A look at a thing: from where, at which, and whether it was seen.
struct Glance {
  Vec3f from{0, 0, 0};
  uint32_t at = 0;
  bool reached = false;
};

/// What glances tell of a few things, each by its number. Learned as in Vevoda, Kondapaneni,
/// Krivanek 2018, "Bayesian online regression for adaptive direct illumination sampling"
/// (vevoda2018bayesian), here by counting: what is seen of a thing from anywhere stands in for a
/// few glances that a region has not taken.
class Chances {
 public:
  /// Knows nothing.
  Chances() = default;
  /// Of `things`; `edge`: see Regions. The order of glances does not matter.
  Chances(const Box3f& bounds, float edge, size_t things, const std::vector<Glance>& glances);

  bool empty() const { return things_ == 0; }
  /// sqrt(p) of each thing, p the chance that it is in sight from there. Where a thing is in sight
  /// with chance p, and then gives E, choosing it in proportion to E sqrt(p) makes the expected
  /// square of the estimate least: the sum of p E^2 over the share of choices.
  const float* at(const Vec3f& point) const {
    return roots_.data() + things_ * row_of_[regions_.at(point)];
  }

 private:
  Regions regions_;
  size_t things_ = 0;
  std::vector<uint32_t> row_of_;  ///< Of each region; 0: none took a glance from there.
  std::vector<float> roots_;      ///< Rows of things.
};

}  // namespace vug::render
