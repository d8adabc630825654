// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/curves/smooth.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

Curve without_close_points(const Curve& curve) {
  Curve out{curve.front()};
  for (size_t i = 1; i < curve.size(); ++i) {
    const bool last = i + 1 == curve.size();
    const double close = curve[i].smaller() / 6;
    const bool near = (curve[i].position - out.back().position).length() < close;
    if (near && !last && !curve[i].fixed) continue;
    // The last point replaces the one before if that one may go.
    if (near && last && out.size() > 1 && !out.back().fixed) out.pop_back();
    out.push_back(curve[i]);
  }
  return out;
}

double angle_between(const Vec3d& a, const Vec3d& b) {
  return maths::atan2(a.cross(b).length(), a.dot(b));
}

Curve subdivided(const Curve& curve, double max_turn) {
  const std::vector<Vec3d> directions = tangents(curve);
  Curve out;
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    const CurvePoint &a = curve[i], &b = curve[i + 1];
    const Vec3d chord = b.position - a.position;
    const double length = chord.length();
    const Vec3d from = directions[i] * length, to = directions[i + 1] * length;
    const double turn =
        angle_between(directions[i], chord) + angle_between(chord, directions[i + 1]);
    // Four pieces follow a change of size by a tenth; more follow larger ones.
    const double size = std::max(a.smaller(), b.smaller());
    const double change = std::max(std::fabs(a.width - b.width) / std::min(a.width, b.width),
                                   std::fabs(a.height - b.height) / std::min(a.height, b.height));
    const double wanted = std::max(1.6 * turn / max_turn, change > 0.1 ? 3 + change : 0);
    const double room = length / (0.25 * size);
    const int pieces = std::clamp(static_cast<int>(std::ceil(std::min(wanted, room))), 1, 24);
    out.push_back(a);
    for (int k = 1; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, u = 1 - t;
      CurvePoint point = between(a, b, t);
      point.position = a.position * (u * u * (1 + 2 * t)) + b.position * (t * t * (3 - 2 * t)) +
                       from * (t * u * u) - to * (t * t * u);
      out.push_back(point);
    }
  }
  out.push_back(curve.back());
  return out;
}

double curvature_at(const Vec3d& before, const Vec3d& here, const Vec3d& after) {
  const Vec3d a = here - before, b = after - here;
  const double product = a.length() * b.length() * (after - before).length();
  return product > 0 ? 2 * a.cross(b).length() / product : 0;
}

void limit_bends(Curve& curve, double max_bend) {
  constexpr int kRounds = 60;
  const Curve original = curve;
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    std::vector<Vec3d> next;
    for (const CurvePoint& p : curve) next.push_back(p.position);
    for (size_t i = 1; i + 1 < curve.size(); ++i) {
      if (curve[i].fixed) continue;
      const Vec3d &a = curve[i - 1].position, &p = curve[i].position, &b = curve[i + 1].position;
      if (curvature_at(a, p, b) * 0.5 * curve[i].width <= max_bend) continue;
      const Vec3d target = p + (0.5 * (a + b) - p) * 0.4;
      Vec3d shift = target - original[i].position;
      const double most = 0.5 * curve[i].smaller();
      if (shift.length() > most) shift *= most / shift.length();
      next[i] = original[i].position + shift;
      moved = true;
    }
    if (!moved) return;
    for (size_t i = 0; i < curve.size(); ++i) curve[i].position = next[i];
  }
}

}  // namespace

Curve smoothed(const Curve& curve, const SmoothOptions& options) {
  Curve out = subdivided(without_close_points(curve), options.max_turn);
  limit_bends(out, options.max_bend);
  return out;
}

std::vector<double> curvatures(const Curve& curve) {
  std::vector<double> out(curve.size(), 0);
  for (size_t i = 1; i + 1 < curve.size(); ++i)
    out[i] = curvature_at(curve[i - 1].position, curve[i].position, curve[i + 1].position);
  return out;
}

}  // namespace vug::passages
