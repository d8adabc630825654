// SPDX-License-Identifier: Apache-2.0
// The scalenohedron {21-31} of calcite, the crystal of dog-tooth spar.
#pragma once

#include <vug/field/node.h>

#include <array>

namespace vug::field {

/// Twelve faces at the same distance from the centre; six of them meet in each of the two tips on
/// the c axis. The value is the maximum of the distances to the faces and to the ball through the
/// tips, at most the distance to the surface.
class Scalenohedron {
 public:
  /// `half` is the distance from the centre to a tip in metres, `c` the unit c axis. The turn about
  /// the axis is in radians.
  Scalenohedron(const Vec3d& centre, const Vec3d& c, double half, double turn);

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> q = p - constant<T>(centre_);
    T most = length(q) - T(half_);
    for (const Vec3d& n : normals_) most = max(most, outside_pair(q, n));
    return most;
  }
  Ball ball() const { return {centre_, half_}; }
  const Vec3d& axis() const { return axis_; }
  const Vec3d& centre() const { return centre_; }
  /// The unit normals of the six faces of the upper tip; the lower ones are their opposites.
  const std::array<Vec3d, 6>& normals() const { return normals_; }

  void add_to(Digester& digester) const { digester(centre_, axis_, half_, face_, normals_); }

 private:
  /// Distance to a face or its opposite: the crystal has a centre of symmetry.
  template <class T>
  T outside_pair(const Point<T>& q, const Vec3d& n) const {
    return abs(dot(q, constant<T>(n))) - T(face_);
  }
  Vec3d centre_, axis_;
  double half_;
  double face_;  ///< Distance of the faces from the centre, metres.
  std::array<Vec3d, 6> normals_;
};

}  // namespace vug::field
