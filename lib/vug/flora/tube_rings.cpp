// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/flora/tube_rings.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

double angle_between(const Vec3d& a, const Vec3d& b) {
  return maths::atan2(a.cross(b).length(), a.dot(b));
}

std::vector<Ring> rings_of(const lsystem::Axis& axis, double begin, double min_radius) {
  std::vector<Ring> rings;
  const auto add = [&](const lsystem::Station& s) {
    if (rings.empty() || (s.position - rings.back().center).length() > 1e-9)
      rings.push_back({s.position, s.frame, s.along, std::max(s.radius, min_radius), s.age});
  };
  if (axis.stations.size() < 2 || begin >= axis.length()) return rings;
  add(lsystem::station_at(axis, begin));
  for (const lsystem::Station& s : axis.stations)
    if (s.along > begin) add(s);
  return rings;
}

/// Normals of the planes that bisect each bend; at the ends the direction of the line.
std::vector<Vec3d> mitre_tangents(const std::vector<Ring>& rings) {
  std::vector<Vec3d> tangents(rings.size());
  const auto direction = [&](size_t i) {
    return (rings[i + 1].center - rings[i].center).normalized();
  };
  tangents.front() = direction(0);
  tangents.back() = direction(rings.size() - 2);
  for (size_t i = 1; i + 1 < rings.size(); ++i) {
    const Vec3d both = direction(i - 1) + direction(i);
    // The axis turns back on itself.
    tangents[i] = both.length() > 0.2 ? both.normalized() : direction(i);
  }
  return tangents;
}

/// Inserts rings on a curve through all of them where it bends by more than `most`.
std::vector<Ring> smoothed(const std::vector<Ring>& rings, double most) {
  const std::vector<Vec3d> tangents = mitre_tangents(rings);
  std::vector<Ring> out = {rings.front()};
  for (size_t i = 1; i < rings.size(); ++i) {
    const Ring &a = rings[i - 1], &b = rings[i];
    const Vec3d chord = b.center - a.center;
    const double bend = angle_between(tangents[i - 1], chord) + angle_between(chord, tangents[i]);
    const int steps = std::clamp(static_cast<int>(std::ceil(bend / most)), 1, 200);
    const double reach = chord.length() / 3;
    for (int k = 1; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps, u = 1 - t;
      Ring ring = b;
      ring.center = a.center * (u * u * u) +
                    (a.center + tangents[i - 1] * reach) * (3 * u * u * t) +
                    (b.center - tangents[i] * reach) * (3 * u * t * t) + b.center * (t * t * t);
      ring.along = a.along * u + b.along * t;
      ring.radius = a.radius * u + b.radius * t;
      ring.age = a.age * u + b.age * t;
      out.push_back(ring);
    }
    out.push_back(b);
  }
  return out;
}

}  // namespace

std::vector<Ring> make_rings(const lsystem::Axis& axis, double begin, const SweepOptions& options) {
  std::vector<Ring> rings = rings_of(axis, begin, options.min_radius);
  if (rings.size() < 2) return {};
  if (axis.order < options.fold_order) rings = smoothed(rings, options.smooth);
  const std::vector<Vec3d> tangents = mitre_tangents(rings);
  std::vector<Vec3d> centers;
  for (const Ring& ring : rings) centers.push_back(ring.center);
  Frame first = rings.front().frame;
  // The turtle's first normal, transported to the actual direction of the line.
  first = transported(first, Vec3d(0), first.tangent + tangents.front(), tangents.front());
  const std::vector<Frame> frames = rotation_minimising(centers, tangents, first);
  for (size_t i = 0; i < rings.size(); ++i) rings[i].frame = frames[i];
  return rings;
}

}  // namespace vug::flora
