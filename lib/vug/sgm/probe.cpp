// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/sgm/probe.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace vug::sgm {

using field::Field;

std::optional<double> first_hit(const Field& field, const Vec3d& origin, const Vec3d& direction,
                                double length) {
  const double least = length / 2048;
  const double inverse = 1 / field.lipschitz();
  double t = 0;
  double value = field.value(origin);
  if (value <= 0) return 0.0;
  while (t < length) {
    double next = std::min(length, t + std::max(value * inverse, least));
    value = field.value(origin + direction * next);
    if (value > 0) {
      t = next;
      continue;
    }
    for (int i = 0; i < 64 && next - t > 1e-15 * length; ++i) {
      const double middle = 0.5 * (t + next);
      (field.value(origin + direction * middle) > 0 ? t : next) = middle;
    }
    return next;
  }
  return std::nullopt;
}

namespace {

/// Rays along one axis, from the face of the bounds inwards.
struct Beam {
  const Field& field;
  int axis, u, v, sign;
  Box3d box;
  double size, length;
  Vec3d centre;

  /// The hit of the ray at (cu, cv) of the cross section, up to `limit`.
  std::optional<double> hit(double cu, double cv, double limit) const {
    return first_hit(field, start(cu, cv), heading(), limit);
  }
  Vec3d heading() const {
    Vec3d out(0);
    out[axis] = -sign;
    return out;
  }
  Vec3d start(double cu, double cv) const {
    Vec3d out;
    out[axis] = (sign > 0 ? box.max : box.min)[axis] + sign * 1e-6 * size;
    out[u] = cu;
    out[v] = cv;
    return out;
  }
};

struct Best {
  double lowest = kInfinity;  ///< Minimum of all hits.
  double t = kInfinity, off = kInfinity, cu = 0, cv = 0;
};

/// count x count rays with half widths (hu, hv) about (cu, cv), rotated by `angle` before scaling.
struct RayGrid {
  double cu, cv, hu, hv;
  int count;
  double angle;
};

/// Traces the rays; returns true if the lowest hit changed.
bool scan(const Beam& beam, const RayGrid& rays, Best& best) {
  const auto& [cu, cv, hu, hv, count, angle] = rays;
  const double cos = maths::cos(angle), sin = maths::sin(angle);
  const double slack = 1e-6 * beam.size, before = best.lowest;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const double x = 2.0 * i / (count - 1) - 1, y = 2.0 * j / (count - 1) - 1;
      const double pu =
          std::clamp(cu + hu * (cos * x - sin * y), beam.box.min[beam.u], beam.box.max[beam.u]);
      const double pv =
          std::clamp(cv + hv * (sin * x + cos * y), beam.box.min[beam.v], beam.box.max[beam.v]);
      const auto t = beam.hit(pu, pv, std::min(beam.length, best.lowest + slack));
      if (!t) continue;
      const double du = pu - beam.centre[beam.u], dv = pv - beam.centre[beam.v];
      const double off = du * du + dv * dv;
      best.lowest = std::min(best.lowest, *t);
      // Ties go to the centre line, unless the best hit so far is no longer extreme.
      if (best.t > best.lowest + slack || off < best.off - slack * beam.size)
        best = {best.lowest, *t, off, pu, pv};
    }
  return best.lowest < before - 1e-3 * slack;
}

}  // namespace

std::optional<Vec3d> support_point(const Field& field, int axis, int sign) {
  const Box3d box = field.bounds();
  if (!is_finite(box)) return std::nullopt;
  const Vec3d extent = box.size();
  const double size = extent.length();
  const Beam beam{field,       axis, (axis + 1) % 3, (axis + 2) % 3,
                  sign,        box,  size,           extent[axis] + 2e-6 * size,
                  box.center()};
  Best best;
  double hu = 0.5 * extent[beam.u], hv = 0.5 * extent[beam.v];
  scan(beam, {beam.centre[beam.u], beam.centre[beam.v], hu, hv, 17, 0}, best);
  if (best.t == kInfinity) {  // The solid slipped between the rays.
    const auto inside = inner_point(field);
    if (!inside) return std::nullopt;
    const auto t = beam.hit((*inside)[beam.u], (*inside)[beam.v], beam.length);
    if (!t) return inside;
    best = {*t, *t, kInfinity, (*inside)[beam.u], (*inside)[beam.v]};
  }
  hu /= 8;
  hv /= 8;
  // A compass search. The pattern rotates by the golden angle, because on a ridge (the edge of a
  // tilted box) few directions ascend, and the window shrinks after three unsuccessful rotations.
  for (int step = 0, vain = 0, level = 0; step < 128 && level < 16; ++step) {
    vain = scan(beam, {best.cu, best.cv, hu, hv, 5, 2.399963 * step}, best) ? 0 : vain + 1;
    if (vain < 3) continue;
    hu *= 0.5;
    hv *= 0.5;
    ++level;
    vain = 0;
  }
  return beam.start(best.cu, best.cv) + beam.heading() * best.t;
}

std::optional<Vec3d> inner_point(const Field& field) {
  constexpr double kHorizon = 100;
  const Box3d box = intersection(field.bounds(), Box3d(Vec3d(-kHorizon), Vec3d(kHorizon)));
  if (box.isEmpty()) return std::nullopt;
  struct Candidate {
    double value;
    int64_t order;
    Vec3d centre, half;
  };
  const auto later = [](const Candidate& a, const Candidate& b) {
    return a.value != b.value ? a.value > b.value : a.order > b.order;
  };
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(later)> queue(later);
  const double size = box.size().length(), smallest = size / 2048;
  int64_t made = 0;
  std::optional<Vec3d> found;
  const auto consider = [&](const Vec3d& centre, const Vec3d& half) {
    const double value = field.value(centre);
    if (value < -1e-9 * size) found = centre;  // Not merely rounding, where walls touch.
    const double radius = half.length();
    if (value <= field.lipschitz() * radius && radius > smallest)
      queue.push({value, made++, centre, half});
  };
  consider(box.center(), box.size() * 0.5);
  constexpr int64_t kMost = 200'000;  // Boxes; a surface with 1/1024 resolution may have more.
  while (!found && !queue.empty() && made < kMost) {
    const Candidate c = queue.top();
    queue.pop();
    const Vec3d half = c.half * 0.5;
    for (int corner = 0; corner < 8 && !found; ++corner)
      consider(c.centre + Vec3d(corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                                corner & 4 ? half.z : -half.z),
               half);
  }
  return found;
}

}  // namespace vug::sgm
