// SPDX-License-Identifier: Apache-2.0
// The steady form of stalagmites: water loses its calcium as it runs down from the apex, so that
// growth along the normal decreases with the area that the water has passed, until the wall is
// vertical.
#pragma once

#include <vector>

#include <vug/base/vec.h>

namespace vug::field {

/// The cosine of the surface's inclination at the radius r is
///   cos(r) = min(1, k - max(0, r^2 - d^2) / R^2),
/// from the balance of calcium in a film of constant discharge. With k = 1 and d = 0 it is the
/// candle, whose curvature at the apex is sqrt(2) / R; with d > 0 the top is flat where drops land
/// within the radius d; with k < 1, the apex is a cone, as under fast drips.
struct StalagmiteForm {
  double radius = 0.05;    ///< The trunk's, sqrt(d^2 + k R^2), metres.
  double landing = 0;      ///< d: the radius within which drops land, metres, less than `radius`.
  double apex_cosine = 1;  ///< k: the cosine of the inclination at the apex, 0..1.
};

class StalagmiteCurve {
 public:
  explicit StalagmiteCurve(const StalagmiteForm& form);

  /// The depth below the apex at a radius less than that of the trunk. Accurate to 1e-9 radii.
  double depth_at(double radius) const;
  /// Points from the apex down to `depth`, x the radius and y the depth, dense where it curves.
  std::vector<Vec2d> points(double depth, int count) const;

 private:
  /// With c = exp(-t) the cosine, dz = sqrt(1 - c^2) R^2 / (2 r) dt, which is smooth in sqrt(t).
  double t_at(double radius) const;
  double radius_at(double t) const;
  double integral(double from, double to) const;

  StalagmiteForm form_;
  double square_;  // R^2
  double first_;   // t at the apex.
};

}  // namespace vug::field
