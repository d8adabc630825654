// SPDX-License-Identifier: Apache-2.0
// The plan of channels that part and meet again in a plane.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/speleogens/frame.h>
#include <vug/field/speleogens/plan_columns.h>

#include <cmath>
#include <cstdint>

namespace vug::field {

/// The channels follow the borders of cells in the plane across `normal`, where the centres of two
/// cells are equally far; two gradient noises bend the plane.
class Braid {
 public:
  /// Metres; `wander` is the sideways deviation of the channels.
  Braid(const Vec3d& normal, double spacing, double wander, RandomStream random)
      : across_(normal), spacing_(spacing), wander_(wander) {
    for (uint32_t& seed : seeds_) seed = random.bits();
  }

  /// Difference of the distances to the two nearest centres in spacings: 0 in the middle of a
  /// channel, and about twice the distance from it.
  template <class T>
  T apart(const Point<T>& p) const {
    const T u = dot(p, constant<T>(across_.side)) * T(1 / spacing_),
            v = dot(p, constant<T>(across_.up)) * T(1 / spacing_);
    const Point<T> low{u * T(kBends), v * T(kBends), T(0.5)};
    const T amount(wander_ / spacing_);
    return plan_column(T(u + amount * gradient_noise(low, seeds_[1])),
                       T(v + amount * gradient_noise(low, seeds_[2])), seeds_[0])
        .inside();
  }
  double spacing() const { return spacing_; }
  /// The maximum slope of the difference in metres.
  double slope() const {
    return 2 * (1 + std::sqrt(2.0) * kBends * kGradientNoiseSlope * wander_ / spacing_);
  }

  void add_to(Digester& digester) const {
    digester(across_, spacing_, wander_, seeds_[0], seeds_[1], seeds_[2]);
  }

 private:
  static constexpr double kBends = 1.3;  ///< Waves of the deviation per spacing.
  Across across_;
  double spacing_, wander_;
  uint32_t seeds_[3] = {};
};

}  // namespace vug::field
