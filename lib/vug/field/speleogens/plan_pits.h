// SPDX-License-Identifier: Apache-2.0
// Round hollows in the plane across an axis, constant along it, which meet in sharp crests.
#pragma once

#include <vug/field/noise.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/frame.h>

namespace vug::field {

/// A hollow: the vector from its centre in the plane, and its size. The unit is the mean width.
template <class S>
struct PlanPit {
  S x, y, size;

  /// 1 in the middle of a hollow of size 1, 0 where the crests between equal ones lie.
  S depth() const { return size - (square(x) + square(y)) * S(4.0) / size; }
};

inline constexpr double kLargestPlanPit = 1.35;  ///< The smallest is 1 / 1.35.

/// The deepest hollow at (x, y). Hollows whose depth is below -1 may be missing.
PlanPit<double> deepest_plan_pit(double x, double y, uint32_t seed);
PlanPit<Pack> deepest_plan_pit(const Pack& x, const Pack& y, uint32_t seed);
template <class S>
PlanPit<Dual<S>> deepest_plan_pit(const Dual<S>& x, const Dual<S>& y, uint32_t seed) {
  const PlanPit<S> pit = deepest_plan_pit(x.v, y.v, seed);
  const S zero(0.0);
  return {{pit.x, x.dx, x.dy, x.dz}, {pit.y, y.dx, y.dy, y.dz}, {pit.size, zero, zero, zero}};
}

/// About -1 in the middle of a hollow and 0 on the crests, on average. Where no hollow is near, the
/// value is limited. `width` is the mean distance between crests along a line, in metres.
class PlanPits {
 public:
  PlanPits(double width, const Vec3d& axis, uint32_t seed)
      : frame_(axis, Vec3d(1 / (kUnit * width))), width_(width), seed_(seed) {}

  template <class T>
  T at(const Point<T>& p) const {
    const Point<T> q = frame_.local(p);
    const T depth = max(deepest_plan_pit(q.y, q.z, seed_).depth(), T(kLowest));
    return (T(kCrest) - depth) * T(1 / (kMiddle - kCrest));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const {
    return {(kCrest - kLargestPlanPit) / (kMiddle - kCrest),
            (kCrest - kLowest) / (kMiddle - kCrest)};
  }
  double lipschitz() const { return kSteepest / (kMiddle - kCrest) / (kUnit * width_); }

 private:
  static constexpr double kUnit = 1.42;     ///< The unit of the hollows, in mean widths.
  static constexpr double kMiddle = 0.92;   ///< Mean depth in the middle of hollows on a line.
  static constexpr double kCrest = 0.45;    ///< Mean depth on crests.
  static constexpr double kLowest = -0.5;   ///< Depth where no hollow is near.
  static constexpr double kSteepest = 5.2;  ///< 8 r / size at kLowest, of the smallest hollow.
  FlowFrame frame_;
  double width_;
  uint32_t seed_;
};

}  // namespace vug::field
