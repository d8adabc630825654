// SPDX-License-Identifier: Apache-2.0
#include <vug/karst/segment_grid.h>

namespace vug::karst {
namespace {

double distance2(const Vec3d& point, const SegmentPiece& s) {
  const Vec3d way = s.to - s.from;
  const double length2 = way.length2();
  const double t = length2 > 0 ? std::clamp((point - s.from).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (s.from + way * t - point).length2();
}

}  // namespace

double distance2(const SegmentPiece& a, const SegmentPiece& b) {
  // Either an end of one segment is nearest to the other, or the distance of their lines counts.
  double least = std::min(std::min(distance2(a.from, b), distance2(a.to, b)),
                          std::min(distance2(b.from, a), distance2(b.to, a)));
  const Vec3d u = a.to - a.from;
  const Vec3d v = b.to - b.from;
  const Vec3d w = a.from - b.from;
  const double uu = u.length2(), uv = u.dot(v), vv = v.length2();
  const double determinant = uu * vv - uv * uv;
  if (determinant > 1e-12 * uu * vv) {
    const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
    const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    if (s > 0 && s < 1 && t > 0 && t < 1) least = std::min(least, (w + u * s - v * t).length2());
  }
  return least;
}

}  // namespace vug::karst
