// SPDX-License-Identifier: Apache-2.0
// An ellipse whose half-axes change linearly along a segment, so that one
// distance replaces two and their blend.
#pragma once

#include <vug/field/numbers/scalar.h>
#include <vug/field/scratch.h>
#include <vug/passages/section.h>

namespace vug::passages {

template <class S>
struct EllipseFoot;

/// The half-axes at t in 0..1 are a = a0 + t a1 and b = b0 + t b1; their frame turns with t. With h
/// the support function of the ellipse, the distance is D = max n . p - h(n) over unit normals n,
/// and dD/dt = -dh/dt at the maximum: |dD/dt| is at most max(|a1|, |b1|) plus |a - b| times the
/// angular speed.
class EllipseLoft {
 public:
  /// A distance in the plane and its derivatives along the axes of the first section, and by t.
  template <class S>
  struct Sample {
    S value, du, dv, dt;
  };

  /// Half-axes of both ends in scene space; they differ by a turn in the plane. Circles have the
  /// direction of the other end. No loft where the axes turn by more than half a radian.
  static std::optional<EllipseLoft> between(Vec3d from_a, Vec3d from_b, Vec3d to_a, Vec3d to_b);

  template <class S>
  Sample<S> sample(const S& u, const S& v, const S& t) const;
  /// `count` samples, whose equations are solved side by side: each step of one waits for the
  /// divisions of the step before.
  void samples(const Pack* u, const Pack* v, const Pack* t, int count, Sample<Pack>* out,
               field::Scratch& scratch) const;

  /// A lower bound of the distance, which is tight near the ellipse and on its axes.
  template <class S>
  S least(const S& u, const S& v, const S& t) const;
  /// Half-axes along `first` and `second` of an ellipse that contains all points at most `distance`
  /// from an ellipse of the loft.
  std::pair<double, double> grown_axes(double distance) const;

  const Vec3d& first() const { return first_; }
  const Vec3d& second() const { return second_; }
  /// The largest |dD/dt|.
  double slope() const;
  /// No distance is below -depth.
  double depth() const;
  /// A bound of the distance from points within to the section at the nearer end moved along.
  double bulge() const;

 private:
  template <class S>
  struct Slice;
  template <class S>
  Slice<S> slice(const S& u, const S& v, const S& t) const;
  template <class S>
  Sample<S> finish(const Slice<S>& at, const EllipseFoot<S>& d) const;
  template <class S>
  Sample<S> sample_circle(const S& u, const S& v, const S& t) const;

  Vec3d first_, second_;  // Unit vectors.
  double a0_ = 1, a1_ = 0, b0_ = 1, b1_ = 0;
  double turn_ = 0, cosine_ = 1, sine_ = 0;
  bool round_ = false;
  int steps_ = 0;
};

}  // namespace vug::passages
