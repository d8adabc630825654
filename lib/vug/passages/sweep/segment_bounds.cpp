// SPDX-License-Identifier: Apache-2.0
// Lower bounds of the values of a segment, which cost less than the values.
#include <vug/passages/sweep/segment.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {

/// A rectangle that contains both sections contains the level set of each blend of their distances,
/// and the signed distance to a larger set is smaller: D is at least the distance to the
/// rectangle, which is at least that along each of its axes. Ellipses have better bounds
/// (EllipseLoft::least), and between two of them D is not a blend.
void Segment::find_box() {
  if (loft_) {
    box_half_ = Vec2d(kInfinity);
    return;
  }
  Vec2d low(kInfinity), high(-kInfinity);
  for (const Plane* plane : {&from_, &to_}) {
    const SectionTraits& t = plane->section->traits();
    for (const double u : {t.min.x, t.max.x})
      for (const double v : {t.min.y, t.max.y}) {
        const Vec3d corner = plane->in_space({u, v});
        const Vec2d at(corner.dot(from_.right), corner.dot(from_.up));
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
      }
  }
  box_centre_ = 0.5 * (low + high);
  box_half_ = 0.5 * (high - low);
}

/// With D >= the distance to the rectangle, D >= d - reach and D >= -depth, d being the distance
/// from the line of the axis, the formula of `finish` is at least |(max(D + depth, 0), e)| - depth
/// for the lower bound of D, which decreases with the depth.
template <class S>
struct Segment::BoxFrame {
  explicit BoxFrame(const Segment& segment)
      : start(field::constant<S>(segment.start_)),
        along(field::constant<S>(segment.along_)),
        right(field::constant<S>(segment.from_.right)),
        up(field::constant<S>(segment.from_.up)),
        length(segment.length_),
        reach(segment.reach_),
        depth(segment.depth_),
        scale(segment.scale_),
        centre_u(segment.box_centre_.x),
        centre_v(segment.box_centre_.y),
        half_u(segment.box_half_.x),
        half_v(segment.box_half_.y) {}

  S least(const Point<S>& p) const {
    using field::abs, field::max, field::sqrt, field::square;
    const Point<S> offset = p - start;
    const S s = dot(offset, along), u = dot(offset, right), v = dot(offset, up);
    const S beyond = max(max(S(0.0) - s, s - length), S(0.0));
    const S box = max(abs(u - centre_u) - half_u, abs(v - centre_v) - half_v);
    const S plane = max(sqrt(square(u) + square(v)) - reach, box);
    return (sqrt(square(max(plane + depth, S(0.0))) + square(beyond)) - depth) * scale;
  }

  Point<S> start, along, right, up;
  S length, reach, depth, scale, centre_u, centre_v, half_u, half_v;
};

void Segment::least(const Point<Pack>* points, size_t count, Pack* out) const {
  const BoxFrame<Pack> frame(*this);
  for (size_t i = 0; i < count; ++i) out[i] = frame.least(points[i]);
}

double Segment::least(const Vec3d& p) const {
  return BoxFrame<double>(*this).least(field::point(p));
}

}  // namespace vug::passages
