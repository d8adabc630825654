// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/speleothems/bisected.h>
#include <vug/field/speleothems/stalactite_curve.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// The slope at the end of the curve, where the radius has its minimum.
const double kLeastSlope = 1 / std::sqrt(3.0);
/// The least radius in units of the scale, 16 / (3 sqrt(3)).
const double kLeastRadius = 16 / (3 * std::sqrt(3.0));

double raw_height(double s) {
  const double square = s * s;
  return 0.75 * square * square + square - maths::log(s);
}

}  // namespace

double StalactiteCurve::radius(double s) const {
  const double sum = 1 + s * s;
  return scale_ * sum * sum / s;
}
double StalactiteCurve::height(double s) const {
  return scale_ * (raw_height(s) - raw_height(kLeastSlope));
}
double StalactiteCurve::least_radius() const { return kLeastRadius * scale_; }

/// The radius grows with the slope from the end on, and is at least scale * slope^3.
double StalactiteCurve::slope_at(double r) const {
  const double high = std::max(1.0, maths::pow(r / scale_, 1.0 / 3)) + kLeastSlope;
  return bisected(kLeastSlope, high, r, [this](double s) { return radius(s); });
}
double StalactiteCurve::height_at(double r) const { return height(slope_at(r)); }

/// The height grows with the slope, and exceeds scale * 3/4 slope^4 less 1.3 scales.
double StalactiteCurve::radius_at(double h) const {
  const double high = maths::pow((h / scale_ + 2) / 0.75, 0.25) + 1;
  return radius(bisected(kLeastSlope, high, h, [this](double s) { return height(s); }));
}

/// A smaller scale makes a longer curve between the same radii.
StalactiteCurve StalactiteCurve::fit(double root, double length, double tip) {
  const auto length_of = [&](double scale) {
    const StalactiteCurve curve(scale);
    return curve.height_at(root) - curve.height_at(std::max(tip, curve.least_radius()));
  };
  const auto shortening = [&](double scale) { return -length_of(scale); };
  double low = root / kLeastRadius;
  while (length_of(low) < length) low *= 0.5;
  return StalactiteCurve(bisected(low, root / kLeastRadius, -length, shortening));
}

std::vector<Vec2d> StalactiteCurve::points(double tip, double root, int count) const {
  const double first = slope_at(std::max(tip, least_radius())), last = slope_at(root);
  const double below = height(first);
  std::vector<Vec2d> out;
  for (int i = 0; i < count; ++i) {
    const double s = first * maths::pow(last / first, static_cast<double>(i) / (count - 1));
    out.emplace_back(radius(s), height(s) - below);
  }
  return out;
}

}  // namespace vug::field
