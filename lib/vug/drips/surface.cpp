// SPDX-License-Identifier: Apache-2.0
#include <vug/drips/surface.h>
#include <vug/field/noise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vug::drips {
namespace {

constexpr int kNewtonSteps = 12;
constexpr double kOnSurface = 1e-7;  // Metres.
/// A bound of the errors of single precision, relative to the largest coordinate: more than thirty
/// units in the last place.
constexpr double kRounding = 2e-6;
constexpr int kHalvings = 24;

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

VerticalLine::Samples VerticalLine::sample(const field::Field& rock,
                                           std::span<const double> heights) const {
  std::array<Vec3f, kMostSamples> points;
  for (size_t i = 0; i < heights.size(); ++i) points[i] = Vec3f(Vec3d(at_.x, heights[i], at_.z));
  Samples values{};
  field::sample(rock, std::span(points).first(heights.size()),
                std::span(values).first(heights.size()));
  return values;
}

/// A bound of the errors of `sample` between two heights. The coordinates of parts of the rock that
/// are far away have larger errors than those of the line.
double VerticalLine::rounding(double from, double to) const {
  double largest = 1 + std::fabs(at_.x) + std::fabs(at_.z) + std::fabs(from) + std::fabs(to);
  const Box3d& box = rock_.bounds();
  for (int axis = 0; axis < 3 && !box.isEmpty(); ++axis)
    for (const double end : {box.min[axis], box.max[axis]})
      if (std::isfinite(end)) largest = std::max(largest, std::fabs(end));
  return kRounding * largest * std::max(1.0, rock_.lipschitz());
}

/// Whether a height is in rock, by its value in single precision unless that may be wrong.
bool VerticalLine::solid(const field::Field& rock, double y, float sampled, double unsure) const {
  return (std::fabs(sampled) > unsure ? static_cast<double>(sampled) : value(rock, y)) <= 0;
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
  if (heights.size() > kMostSamples) {
    const size_t middle = heights.size() / 2;
    if (const auto found = first_change(local.field, heights.first(middle + 1), inside))
      return found;
    return first_change(local.field, heights.subspan(middle), inside);
  }
  const double unsure = rounding(heights.front(), heights.back());
  const Samples values = sample(local.field, heights);
  for (size_t i = 1; i < heights.size(); ++i)
    if (solid(local.field, heights[i], values[i], unsure) != inside)
      return refined(local.field, heights[i - 1], heights[i], inside);
  return std::nullopt;
}

/// Halves the interval. The middles of the next three halvings, of which each depends on the sign
/// at the one before, are seven heights, which are sampled together.
double VerticalLine::refined(const field::Field& rock, double near, double far, bool inside) const {
  constexpr size_t kMiddles = 7;
  struct Part {
    double near, far;
    double middle() const { return 0.5 * (near + far); }
  };
  const field::Field local = rock.restricted(ball(near, far)).field;
  const double unsure = rounding(near, far);
  Part part{near, far};
  for (int i = 0; i < kHalvings; i += 3) {
    std::array<Part, 2 * kMiddles + 1> parts{{part}};  // As a heap.
    std::array<double, kMiddles> middles;
    for (size_t k = 0; k < kMiddles; ++k) {
      middles[k] = parts[k].middle();
      parts[2 * k + 1] = {parts[k].near, middles[k]};
      parts[2 * k + 2] = {middles[k], parts[k].far};
    }
    // No value of a shorter part is certain, because the part contains a zero.
    Samples values{};
    if (std::fabs(part.far - part.near) * rock_.lipschitz() > unsure)
      values = sample(local, middles);
    size_t k = 0;
    while (k < kMiddles)
      k = 2 * k + (solid(local, middles[k], values[k], unsure) == inside ? 2 : 1);
    part = parts[k];
  }
  return part.middle();
}

}  // namespace vug::drips
