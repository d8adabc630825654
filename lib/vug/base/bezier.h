// Cubic Bezier curves, by parameter and by arc length.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <vector>

namespace vug {

/// Control points in metres; the parameter t runs from 0 to 1.
struct Bezier {
  std::array<Vec3d, 4> control;

  Vec3d point(double t) const;
  Vec3d derivative(double t) const;  ///< Metres for each unit of t.
  Vec3d second(double t) const;      ///< The second derivative.
  /// Unit length, also at ends whose inner control point lies on the end.
  Vec3d tangent(double t) const;
  /// The parts before and after t, by de Casteljau.
  std::array<Bezier, 2> split(double t) const;
  bool operator==(const Bezier&) const = default;
};

/// A Bezier curve by the length along it. The length is never below the chord and never above the
/// control polygon of any subdivision; each piece is halved until Gauss' rule with 8 points and
/// twice 8 points agree to `tolerance` of the polygon's length.
class ArcBezier {
 public:
  /// Error(bad_input) where a coordinate is not finite or all control points are the same.
  explicit ArcBezier(const Bezier& curve, double tolerance = 1e-12);

  const Bezier& curve() const { return curve_; }
  double length() const { return lengths_.back(); }  ///< Metres.
  /// Metres from the start to the parameter t in 0..1.
  double length_to(double t) const;
  /// The t at which `length_to` is `along`, which is kept in 0..length().
  double parameter(double along) const;
  Vec3d point(double along) const { return curve_.point(parameter(along)); }
  Vec3d tangent(double along) const { return curve_.tangent(parameter(along)); }

 private:
  void add_pieces(double from, double to, double whole, double tolerance, int depth);

  Bezier curve_;
  std::vector<double> parameters_{0};  ///< Where pieces end.
  std::vector<double> lengths_{0};     ///< From the start to there.
};

/// The Bezier curve of a stem of this length that leaves its foot `lean` from the plumb and ends at
/// the angle `tip` from it (above 90 degrees it hangs), towards an azimuth (0: +x, 90 degrees: -z).
/// The share `stiff` of the control polygon keeps the direction of the foot: gravity bends what is
/// thin. Angles in radians; Error(bad_input) unless length > 0 and 0 < stiff < 1.
Bezier drooping(double length, double lean, double tip, double azimuth, double stiff);

}  // namespace vug
