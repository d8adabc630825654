// SPDX-License-Identifier: Apache-2.0
// Cubic Bezier curves, evaluated by parameter and by arc length.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <vector>

namespace vug {

/// Control points in metres; the parameter t runs from 0 to 1.
struct Bezier {
  std::array<Vec3d, 4> control;

  Vec3d point(double t) const;
  Vec3d derivative(double t) const;  ///< Metres per unit of t.
  Vec3d second(double t) const;      ///< The second derivative.
  /// Unit length, even at an end whose inner control point coincides with the end point.
  Vec3d tangent(double t) const;
  /// The parts before and after t, by de Casteljau's algorithm.
  std::array<Bezier, 2> split(double t) const;
  bool operator==(const Bezier&) const = default;
};

/// A Bezier curve parametrized by arc length. The length is never below the chord and never above
/// the control polygon of any subdivision. Each piece is halved until the 8-point Gauss rule on the
/// piece and on its two halves agree to `tolerance` times the polygon's length.
class ArcBezier {
 public:
  /// Throws Error(bad_input) if a coordinate is not finite or all control points coincide.
  explicit ArcBezier(const Bezier& curve, double tolerance = 1e-12);

  const Bezier& curve() const { return curve_; }
  double length() const { return lengths_.back(); }  ///< Metres.
  /// Arc length in metres from the start to the parameter t in 0..1.
  double length_to(double t) const;
  /// The t at which `length_to` equals `along`, which is clamped to 0..length().
  double parameter(double along) const;
  Vec3d point(double along) const { return curve_.point(parameter(along)); }
  Vec3d tangent(double along) const { return curve_.tangent(parameter(along)); }

 private:
  void add_pieces(double from, double to, double whole, double tolerance, int depth);

  Bezier curve_;
  std::vector<double> parameters_{0};  ///< Parameters at the ends of the pieces.
  std::vector<double> lengths_{0};     ///< Arc lengths from the start to those ends.
};

/// The Bezier curve of a stem of this length in metres. It starts at the angle `lean` from the
/// vertical and ends at the angle `tip` from it (above 90 degrees the tip hangs), towards an
/// azimuth (0: +x, 90 degrees: -z). The fraction `stiff` of the control polygon keeps the direction
/// of the foot, because gravity bends the thin end. Angles are in radians. Throws Error(bad_input)
/// unless length > 0 and 0 < stiff < 1.
Bezier drooping(double length, double lean, double tip, double azimuth, double stiff);

}  // namespace vug
