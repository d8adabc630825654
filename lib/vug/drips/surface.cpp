// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::drips {
namespace {

constexpr int kNewtonSteps = 12;
constexpr double kOnSurface = 1e-7;  // Metres.
constexpr size_t kFewSamples = 12;   // Of a line; more are divided.

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

/// The ball around the part of the line between two heights.
field::Ball VerticalLine::ball(double a, double b) const {
  return {{at_.x, 0.5 * (a + b), at_.z}, 0.5 * std::fabs(b - a) * (1 + 1e-9) + 1e-9};
}

std::optional<double> VerticalLine::crossing(double from, double to) const {
  const double way = to < from ? -1 : 1, length = std::fabs(to - from);
  std::vector<double> heights = {from};
  for (double s = 0; s < length;) {
    s = std::min(s + step_, length);
    heights.push_back(from + way * s);
  }
  return first_change(rock_, heights, solid(from));
}

/// The change between the first of these samples, which is `inside`, and the others. Bisects the
/// samples, because the expression is short in a small ball and often has one sign there.
std::optional<double> VerticalLine::first_change(const field::Field& rock,
                                                 std::span<const double> heights,
                                                 bool inside) const {
  if (heights.size() < 2) return std::nullopt;
  const auto local = rock.restricted(ball(heights.front(), heights.back()));
  if (inside ? local.range.hi <= 0 : local.range.lo > 0) return std::nullopt;
  if (heights.size() > kFewSamples) {
    const size_t middle = heights.size() / 2;
    if (const auto found = first_change(local.field, heights.first(middle + 1), inside))
      return found;
    return first_change(local.field, heights.subspan(middle), inside);
  }
  double known = heights.front(), clear = 0;
  for (size_t i = 1; i < heights.size(); ++i) {
    if (std::fabs(heights[i] - known) < clear) continue;
    const double there = value(local.field, heights[i]);
    if ((there <= 0) != inside) return refined(local.field, heights[i - 1], heights[i], inside);
    known = heights[i];
    clear = clearance(there);
  }
  return std::nullopt;
}

double VerticalLine::refined(const field::Field& rock, double near, double far, bool inside) const {
  const field::Field local = rock.restricted(ball(near, far)).field;
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (near + far);
    ((value(local, middle) <= 0) == inside ? near : far) = middle;
  }
  return 0.5 * (near + far);
}

}  // namespace vug::drips
