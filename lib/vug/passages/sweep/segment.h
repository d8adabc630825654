// SPDX-License-Identifier: Apache-2.0
// One straight piece of a passage: the section at its start lofted to that at its end, with rounded
// caps beyond both.
#pragma once

#include <vug/field/near_surface.h>
#include <vug/passages/section.h>
#include <vug/passages/sweep/capsule.h>
#include <vug/passages/sweep/ellipse_loft.h>

namespace vug::passages {

using field::Dual;
using field::Point;

class PackedLanes;

/// A section at a point of a passage's axis, in scene space.
struct SectionFrame {
  Vec3d position{0.0};
  Vec3d right{1, 0, 0};  ///< The direction of u, a unit vector.
  Vec3d up{0, 1, 0};     ///< The direction of v, a unit vector perpendicular to `right`.
  SectionPtr section;
};

/// With s the coordinate along the axis (0 to L), D = (1 - t) D_from + t D_to with t = s / L
/// clamped to 0..1 the lofted distance in the plane, and e the distance of s beyond the ends, the
/// field is
///   f = scale * (|(D + r, e)| - r)   with r the depth of the section at that end,
/// which is D between the ends: circles continue as half spheres, other sections shrink by what a
/// half sphere does. The slope along the axis is at most sigma = max |D_from - D_to| / L, and scale
/// = 1 / sqrt(1 + sigma^2), so the Lipschitz constant is 1. Between two ellipses, D is instead the
/// distance to an ellipse whose half-axes are interpolated (EllipseLoft). The axis is never bent:
/// no point is projected onto a curve, which would be discontinuous at the medial axis of bends.
class Segment {
 public:
  /// Error(bad_input) if the positions coincide. The frames are turned into the plane across the
  /// axis.
  Segment(const SectionFrame& from, const SectionFrame& to);

  double value(const Point<double>& p) const { return at(p); }
  template <class T>  // double or Dual<double>
  T at(const Point<T>& p) const;
  template <class T>  // Pack or Dual<Pack>
  void fill(const Point<Pack>* points, int count, T* out, field::Scratch& scratch) const;

  Capsule capsule() const { return {start_, along_, length_, reach_, scale_}; }
  /// Higher lower bounds than those of the capsule, for a batch of points and for one.
  void least(const Point<Pack>* points, size_t count, Pack* out) const;
  double least(const Vec3d& p) const;
  /// The rounding of `least` and of values in double precision at a point.
  double rounding(const Vec3d& p) const { return 1e-12 * (1 + p.length() + reach_ + length_); }

  /// Chooses the lanes of a block at which the value can be at most `limit`, and at most the known
  /// value of the lane plus `above` where `known` is given: one pack for each run.
  void pack_below(const field::LatticeBlock& block, double limit, double above, const Pack* known,
                  PackedLanes& out) const;
  /// Computes FirstOrder or Dual<Pack> at the lanes that `pack_below` of this segment chose.
  template <class T>
  void fill_packed(PackedLanes& lanes, field::Scratch& scratch) const;

  const Vec3d& start() const { return start_; }
  Vec3d end() const { return start_ + along_ * length_; }
  /// The diameter of the largest circle in the smaller one of its sections, and its place.
  std::pair<double, Vec3d> thinnest() const {
    return from_.depth <= to_.depth ? std::pair(2 * from_.depth, start_)
                                    : std::pair(2 * to_.depth, end());
  }
  double reach() const { return reach_; }
  double scale() const { return scale_; }
  bool uniform() const { return uniform_; }
  /// A box around the inside; outside of it the field grows at least with the rate `scale()`.
  Box3d bounds() const;

  void add_to(Digester& digester) const { digester(start_, along_, length_, from_, to_); }

 private:
  struct Plane {
    Vec3d right, up;
    SectionPtr section;
    double depth = 0;
    void add_to(Digester& digester) const { digester(right, up, section); }
    Vec3d in_space(const Vec2d& p) const { return right * p.x + up * p.y; }
  };
  Plane plane(const SectionFrame& frame) const;
  static double difference(const Plane& one, const Plane& other);
  void find_box();
  double slope() const;
  template <class T>
  T finish(const T& from, const T& to, const T& s) const;
  template <class T>
  static T across(const Plane& plane, const Point<T>& offset);
  template <class S>
  struct BoxFrame;
  template <class S>
  struct AxisFrame;
  template <class S>
  struct LoftFrame;
  class BlockFrame;
  Dual<double> lofted(const Point<double>& p) const;
  template <class T>
  void fill_lofted(const Point<Pack>* points, int count, T* out, field::Scratch& scratch) const;
  template <class D>
  void sample(const Plane& plane, const Point<Pack>* points, int count, D* out,
              field::Scratch& scratch) const;

  Vec3d start_, along_;
  double length_;
  Plane from_, to_;
  bool uniform_ = false;
  std::optional<EllipseLoft> loft_;
  double scale_ = 1, reach_ = 0, depth_ = 0;
  Vec2d box_centre_{0, 0}, box_half_{0, 0};  // Around both sections, in the frame of the first.
};

}  // namespace vug::passages
