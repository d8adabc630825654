// SPDX-License-Identifier: Apache-2.0
// Nodes that can be evaluated faster if only values near their surface matter, as in a narrow band.
#pragma once

#include <vug/field/node.h>

#include <cmath>

namespace vug::field {

/// 8^3 points of a lattice in 64 runs along z. Run 8 * x + y starts at origin + step * (x, y, 0).
struct LatticeBlock {
  static constexpr size_t kRuns = 64;
  Vec3d origin{0.0};
  double step = 0;  ///< Metres.

  Ball ball() const {
    const double half = 3.5 * step;
    return {origin + Vec3d(half), half * std::sqrt(3.0)};
  }
};

/// A value and the distance that follows from it to first order, value / |gradient|. Distances have
/// no meaning where the gradient vanishes.
struct FirstOrder {
  Pack value, distance;
};
/// `least` is the smallest square of a slope that is not rounding.
inline FirstOrder first_order_of(const Dual<Pack>& x, const Pack& least = Pack(1e-12)) {
  const Pack squared = x.dx * x.dx + x.dy * x.dy + x.dz * x.dz;
  return {x.v, x.v / sqrt(max(squared, least))};
}

/// One pack for each run of a block.
struct FirstOrderRuns {
  Pack* values;
  Pack* distances;
};

/// Where the values of a block are: all above the limit, all below -limit, or near the surface.
enum class BlockRange { above, below, near };

/// "Near the surface" means: where |value| <= limit. Elsewhere results may have any value of the
/// same sign beyond the limit.
class NearSurface {
 public:
  virtual ~NearSurface() = default;
  /// As Node::restrict_to, but the bounds and the values of the restricted node are those of this
  /// node only near the surface. The restricted node must be restricted further with the same limit
  /// or a smaller one.
  virtual Restriction restrict_near(const Ball& ball, double limit) const = 0;
  /// Fills the values and distances of FirstOrder for the runs of a block that is `near`; others
  /// leave the arrays as they are. Blocks without a value near the surface may be `near`, too.
  virtual BlockRange first_order(const LatticeBlock& block, double limit, const FirstOrderRuns& out,
                                 Scratch& scratch) const = 0;

 protected:
  NearSurface() = default;
  NearSurface(const NearSurface&) = default;
  NearSurface& operator=(const NearSurface&) = default;
};

}  // namespace vug::field
