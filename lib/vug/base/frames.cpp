// SPDX-License-Identifier: Apache-2.0
#include <vug/base/frames.h>
#include <vug/base/maths.h>

#include <cmath>

namespace vug {

Vec3d rotated(const Vec3d& v, const Vec3d& axis, double angle) {
  const double c = maths::cos(angle), s = maths::sin(angle);
  return v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c));
}

Vec3d Frame::around(double angle) const {
  return normal * maths::cos(angle) + binormal * maths::sin(angle);
}

Frame Frame::rotated(const Vec3d& axis, double angle) const {
  Frame out;
  out.tangent = vug::rotated(tangent, axis, angle);
  out.normal = vug::rotated(normal, axis, angle);
  out.binormal = vug::rotated(binormal, axis, angle);
  return out.orthonormalized();
}

Frame Frame::orthonormalized() const {
  Frame out;
  out.tangent = tangent.normalized();
  out.normal = (normal - out.tangent * normal.dot(out.tangent)).normalized();
  out.binormal = out.tangent.cross(out.normal);
  return out;
}

Frame level_frame(const Vec3d& tangent) {
  Frame out;
  out.tangent = tangent.normalized();
  const Vec3d level = Vec3d(0, 1, 0).cross(out.tangent);
  out.normal = level.length() > 1e-9 ? level.normalized() : Vec3d(1, 0, 0);
  return out.orthonormalized();
}

Frame transported(const Frame& frame, const Vec3d& from, const Vec3d& to, const Vec3d& tangent) {
  const Vec3d chord = to - from;
  const double chord2 = chord.dot(chord);
  Frame out;
  out.tangent = tangent;
  if (chord2 == 0) {
    out.normal = frame.normal;
  } else {
    const Vec3d normal = frame.normal - chord * (2 / chord2 * chord.dot(frame.normal));
    const Vec3d mirrored = frame.tangent - chord * (2 / chord2 * chord.dot(frame.tangent));
    const Vec3d rest = tangent - mirrored;
    const double rest2 = rest.dot(rest);
    // For a curve that reverses there is no second reflection: the first one keeps the normal
    // perpendicular.
    out.normal = rest2 > 1e-24 ? normal - rest * (2 / rest2 * rest.dot(normal)) : normal;
  }
  return out.orthonormalized();
}

std::vector<Frame> rotation_minimising(const std::vector<Vec3d>& points,
                                       const std::vector<Vec3d>& tangents, const Frame& first) {
  std::vector<Frame> frames;
  frames.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i)
    frames.push_back(i == 0 ? first
                            : transported(frames[i - 1], points[i - 1], points[i], tangents[i]));
  return frames;
}

}  // namespace vug
