// SPDX-License-Identifier: Apache-2.0
// The ideal form of stalactites (short2005): a film of water thins where the surface is wide, and
// deposits in proportion to its thickness, so that the form moves down without changing.
#pragma once

#include <vector>

#include <vug/base/vec.h>

namespace vug::field {

/// The profile, with r the radius, z the height above the end of the curve and s = dz/dr >=
/// 1/sqrt(3):
///   r(s) = a (1 + s^2)^2 / s,   z(s) = a (3/4 s^4 + s^2 - ln s - C0),   z(1/sqrt(3)) = 0.
/// At its end the curve has the slope of 30 degrees and the radius 16 a / (3 sqrt(3)); the pendent
/// drop lies below.
class StalactiteCurve {
 public:
  /// `scale` is a, in metres.
  explicit StalactiteCurve(double scale) : scale_(scale) {}

  /// The curve that is `length` long from the radius `root` down to the radius `tip`, all in
  /// metres, with tip < root. A stalactite that is too short for that has a wider, blunt tip.
  static StalactiteCurve fit(double root, double length, double tip);

  double scale() const { return scale_; }
  double least_radius() const;
  /// The slope dz/dr at a radius of at least least_radius().
  double slope_at(double radius) const;
  /// Height above the end at a radius of at least least_radius().
  double height_at(double radius) const;
  /// The radius at a height above the end.
  double radius_at(double height) const;
  /// Points from the radius `tip` to the radius `root`, x the radius and y the height above the
  /// first point, in geometric steps of the slope. Radii below least_radius() become that.
  std::vector<Vec2d> points(double tip, double root, int count) const;

 private:
  double radius(double slope) const;
  double height(double slope) const;

  double scale_;
};

}  // namespace vug::field
