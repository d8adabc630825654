// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/speleothems/dome_curve.h>

#include <cmath>

namespace vug::field {

double dome_radius(double s) { return std::sqrt(s * (1 + s * s)); }

/// Over q = s^(1/2), dr/dq = (1 + 3 q^4) / (1 + q^4)^(1/2), without a singularity; Simpson's rule.
double dome_depth(double s) {
  constexpr int kPieces = 256;
  const auto integrand = [](double q) {
    const double s2 = q * q * q * q;
    return q * q * (1 + 3 * s2) / std::sqrt(1 + s2);
  };
  const double step = std::sqrt(s) / kPieces;
  double sum = 0;
  for (int i = 0; i < kPieces; ++i)
    sum += integrand(i * step) + 4 * integrand((i + 0.5) * step) + integrand((i + 1) * step);
  return sum * step / 6;
}

std::vector<Vec2d> dome_points(double radius, double slope, int count) {
  const double foot = maths::tan(slope), scale = radius / dome_radius(foot);
  const double height = scale * dome_depth(foot);
  std::vector<Vec2d> out;
  for (int i = 0; i < count; ++i) {
    const double part = 1 - static_cast<double>(i) / (count - 1);
    const double s = foot * part * part;
    out.emplace_back(scale * dome_radius(s), height - scale * dome_depth(s));
  }
  return out;
}

}  // namespace vug::field
