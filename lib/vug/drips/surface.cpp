// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/surface.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

constexpr int kNewtonSteps = 12;
constexpr double kOnSurface = 1e-7;  // Metres.

}  // namespace

Vec3d normal_at(const field::Field& rock, const Vec3d& p) {
  const Vec3d slope = rock.gradient(p).gradient;
  const double steep = slope.length();
  return steep > 0 ? slope / steep : Vec3d(0.0);
}

std::optional<Vec3d> onto_surface(const field::Field& rock, const Vec3d& p, double reach) {
  Vec3d q = p;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const field::Gradient g = rock.gradient(q);
    const double square = g.gradient.length2();
    if (!(square > 1e-12)) return std::nullopt;
    const Vec3d step = g.gradient * (g.value / square);
    q -= step;
    if (!((q - p).length() <= reach)) return std::nullopt;
    if (step.length() < kOnSurface) return q;
  }
  return std::nullopt;
}

/// A distance within which the sign cannot differ from that of the value, less a margin for
/// rounding.
double VerticalLine::clearance(double value) const {
  const double size = std::fabs(value);
  return size > 1e-6 ? (size - 1e-6) / rock_.lipschitz() * (1 - 1e-6) : 0;
}

std::optional<double> VerticalLine::crossing(double from, double to) const {
  const double way = to < from ? -1 : 1, length = std::fabs(to - from);
  const double first = value(rock_, from);
  const bool inside = first <= 0;
  for (double s = 0, known = clearance(first); s < length;) {
    const double next = std::min(s + step_, length);
    if (next >= known) {
      const double there = value(rock_, from + way * next);
      if ((there <= 0) != inside) return refined(from + way * s, from + way * next, inside);
      known = next + clearance(there);
    }
    s = next;
  }
  return std::nullopt;
}

double VerticalLine::refined(double near, double far, bool inside) const {
  const field::Ball ball{{at_.x, 0.5 * (near + far), at_.z},
                         0.5 * std::fabs(far - near) * (1 + 1e-9) + 1e-9};
  const field::Field local = rock_.restricted(ball).field;
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (near + far);
    ((value(local, middle) <= 0) == inside ? near : far) = middle;
  }
  return 0.5 * (near + far);
}

}  // namespace vug::drips
