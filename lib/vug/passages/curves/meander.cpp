// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/passages/curves/meander.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr int kPerHalfWave = 10;

double bessel_j0(double x) {
  // (1 / pi) times the integral of cos(x sin t) over half a turn: the trapezoidal rule converges
  // exponentially for a periodic integrand.
  constexpr int kSteps = 64;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += maths::cos(x * maths::sin(kPi * i / kSteps));
  return sum / kSteps;
}

/// Positions along and across the valley at steps of half a wave, for one whole wave of length 1.
std::vector<Vec2d> unit_wave(double omega) {
  constexpr int kFine = 40;
  std::vector<Vec2d> points{{0, 0}};
  Vec2d at(0, 0);
  for (int i = 0; i < 2 * kPerHalfWave; ++i) {
    for (int k = 0; k < kFine; ++k) {
      const double s = (i + (k + 0.5) / kFine) / (2 * kPerHalfWave);
      const double angle = omega * maths::cos(2 * kPi * s);
      at += Vec2d(maths::cos(angle), maths::sin(angle)) / (2 * kPerHalfWave * kFine);
    }
    points.push_back(at);
  }
  const double advance = points.back().x;
  for (Vec2d& p : points) p /= advance;
  return points;
}

/// The part of a curve between two indices, as a function of the arc length from the first.
class Valley {
 public:
  Valley(const Curve& curve, size_t first, size_t last) : curve_(curve), first_(first) {
    lengths_.push_back(0);
    for (size_t i = first + 1; i <= last; ++i)
      lengths_.push_back(lengths_.back() + (curve[i].position - curve[i - 1].position).length());
  }
  double length() const { return lengths_.back(); }
  CurvePoint at(double s, Vec3d& aside) const {
    size_t piece = 1;
    while (piece + 1 < lengths_.size() && lengths_[piece] < s) ++piece;
    const CurvePoint &a = curve_[first_ + piece - 1], &b = curve_[first_ + piece];
    const double span = lengths_[piece] - lengths_[piece - 1];
    const double t = span > 0 ? std::clamp((s - lengths_[piece - 1]) / span, 0.0, 1.0) : 0;
    CurvePoint point = between(a, b, t);
    const Vec3d ahead = b.position - a.position;
    aside = Vec3d(-ahead.z, 0, ahead.x);
    if (aside.length() > 0) aside.normalize();
    return point;
  }

 private:
  const Curve& curve_;
  size_t first_;
  std::vector<double> lengths_;
};

bool can_meander(const Curve& curve, size_t first, size_t last) {
  for (size_t i = first; i < last; ++i) {
    const Vec3d way = curve[i + 1].position - curve[i].position;
    if (curve[i].stage == network::Stage::phreatic) return false;
    if (std::fabs(way.y) > 0.70710678 * way.length()) return false;
  }
  return true;
}

void append_meanders(const Curve& curve, size_t first, size_t last, const MeanderOptions& options,
                     const std::vector<Vec2d>& wave, Curve& out) {
  const Valley valley(curve, first, last);
  double width = 0;
  for (size_t i = first; i <= last; ++i) width += curve[i].width;
  width /= static_cast<double>(last - first + 1);
  const double half = 0.5 * options.wavelength * width;
  const auto halves = static_cast<int>(std::lround(valley.length() / half));
  if (halves < 1 || !can_meander(curve, first, last)) {
    for (size_t i = first + 1; i < last; ++i) out.push_back(curve[i]);
    return;
  }
  const double lambda = 2 * valley.length() / halves;
  for (int i = 1; i < halves * kPerHalfWave; ++i) {
    const Vec2d& p = wave[static_cast<size_t>(i % (2 * kPerHalfWave))];
    const int whole_waves = i / (2 * kPerHalfWave);
    const double x = p.x + whole_waves;
    Vec3d aside;
    CurvePoint point = valley.at(x * lambda, aside);
    point.position += aside * (p.y * lambda);
    out.push_back(point);
  }
}

}  // namespace

double meander_amplitude(double sinuosity) {
  double low = 0, high = 2.2;  // J0 falls from 1 to 0.11 there.
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (1 / bessel_j0(middle) < sinuosity ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Curve meandered(const Curve& curve, const MeanderOptions& options) {
  if (!(options.sinuosity >= 1 && options.sinuosity <= 3.5) || !(options.wavelength > 0) ||
      !std::isfinite(options.wavelength))
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid meanders with sinuosity {} and a wavelength of {} widths",
                            options.sinuosity, options.wavelength),
                {}, "use a sinuosity of 1 to 3.5 and a wavelength above 0");
  if (options.sinuosity == 1 || curve.size() < 2) return curve;
  const std::vector<Vec2d> wave = unit_wave(meander_amplitude(options.sinuosity));
  Curve out;
  for (size_t first = 0; first + 1 < curve.size();) {
    size_t last = first + 1;
    while (last + 1 < curve.size() && !curve[last].fixed) ++last;
    out.push_back(curve[first]);
    append_meanders(curve, first, last, options, wave, out);
    first = last;
  }
  out.push_back(curve.back());
  return out;
}

}  // namespace vug::passages
