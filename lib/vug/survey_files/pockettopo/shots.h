// SPDX-License-Identifier: Apache-2.0
// Shots of an electronic instrument and their average: surveyors repeat each leg, mostly three
// times, and measure splays once.
#pragma once

#include <vug/base/vec.h>
#include <vug/survey/measurement.h>

namespace vug::survey::pockettopo {

/// A shot in metres and radians; bearing from true north, gradient positive upwards.
struct Shot {
  double length = 0;
  double bearing = 0;
  double gradient = 0;

  /// Unit vector.
  Vec3d direction() const;
  Shot reversed() const;
};

/// Shots of one leg.
class RepeatedShot {
 public:
  /// The largest differences between shots of one leg: 5 cm and 1.7 degrees, as in PocketTopo.
  static constexpr double kLengthTolerance = 0.05;
  static constexpr double kAngleTolerance = 1.7 * kPi / 180;

  explicit RepeatedShot(const Shot& first) { add(first); }

  bool agrees(const Shot& shot) const;
  void add(const Shot& shot);
  Shot mean() const;
  /// The mean as a vector, with the variances of Survex's model. The variance of n readings is that
  /// of one divided by n.
  MeasuredVector measured(const Deviations& deviations) const;

 private:
  int count_ = 0;
  Shot first_;
  double length_ = 0;  ///< The sum of the lengths.
  Vec3d sum_{0.0};     ///< The sum of the directions.
};

}  // namespace vug::survey::pockettopo
