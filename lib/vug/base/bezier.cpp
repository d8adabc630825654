// SPDX-License-Identifier: Apache-2.0
#include <vug/base/bezier.h>
#include <vug/base/error.h>
#include <vug/base/maths.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

/// One half of the symmetric 8-point Gauss-Legendre rule.
constexpr std::array<double, 4> kNodes = {0.1834346424956498, 0.5255324099163290,
                                          0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> kWeights = {0.3626837833783620, 0.3137066458778873,
                                            0.2223810344533745, 0.1012285362903763};

double gauss(const Bezier& curve, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (size_t i = 0; i < kNodes.size(); ++i)
    sum += kWeights[i] * (curve.derivative(middle - half * kNodes[i]).length() +
                          curve.derivative(middle + half * kNodes[i]).length());
  return half * sum;
}

double polygon_length(const Bezier& curve) {
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += (curve.control[i + 1] - curve.control[i]).length();
  return sum;
}

Vec3d between(const Vec3d& a, const Vec3d& b, double t) { return a * (1 - t) + b * t; }

}  // namespace

Vec3d Bezier::point(double t) const { return split(t)[0].control[3]; }

Vec3d Bezier::derivative(double t) const {
  const double u = 1 - t;
  return (control[1] - control[0]) * (3 * u * u) + (control[2] - control[1]) * (6 * u * t) +
         (control[3] - control[2]) * (3 * t * t);
}

Vec3d Bezier::second(double t) const {
  return (control[2] - control[1] * 2 + control[0]) * (6 * (1 - t)) +
         (control[3] - control[2] * 2 + control[1]) * (6 * t);
}

Vec3d Bezier::tangent(double t) const {
  const double size = polygon_length(*this);
  const Vec3d first = derivative(t);
  if (first.length() > 1e-9 * size) return first.normalized();
  // Where the speed is 0, the curve leaves along its second derivative and arrives against it.
  const Vec3d way = second(t) * (t < 0.5 ? 1 : -1);
  if (way.length() > 1e-9 * size) return way.normalized();
  return (control[3] - control[0]).normalized();
}

std::array<Bezier, 2> Bezier::split(double t) const {
  const Vec3d a = between(control[0], control[1], t), b = between(control[1], control[2], t),
              c = between(control[2], control[3], t), ab = between(a, b, t), bc = between(b, c, t),
              abc = between(ab, bc, t);
  return {Bezier{{control[0], a, ab, abc}}, Bezier{{abc, bc, c, control[3]}}};
}

ArcBezier::ArcBezier(const Bezier& curve, double tolerance) : curve_(curve) {
  const double size = polygon_length(curve);
  if (!std::isfinite(size) || size <= 0)
    throw Error(ErrorCode::bad_input,
                "invalid curve: control points must be finite and must not all coincide");
  add_pieces(0, 1, gauss(curve, 0, 1), std::max(tolerance, 1e-15) * size, 0);
}

void ArcBezier::add_pieces(double from, double to, double whole, double tolerance, int depth) {
  constexpr int kDeepest = 40;
  const double middle = 0.5 * (from + to);
  const double left = gauss(curve_, from, middle), right = gauss(curve_, middle, to);
  if (std::fabs(left + right - whole) > tolerance && depth < kDeepest) {
    add_pieces(from, middle, left, 0.5 * tolerance, depth + 1);
    add_pieces(middle, to, right, 0.5 * tolerance, depth + 1);
    return;
  }
  parameters_.push_back(to);
  lengths_.push_back(lengths_.back() + left + right);
}

double ArcBezier::length_to(double t) const {
  t = std::clamp(t, 0.0, 1.0);
  const auto next = std::upper_bound(parameters_.begin(), parameters_.end() - 1, t);
  const auto i = static_cast<size_t>(next - parameters_.begin()) - 1;
  const double middle = 0.5 * (parameters_[i] + t);
  return lengths_[i] + gauss(curve_, parameters_[i], middle) + gauss(curve_, middle, t);
}

double ArcBezier::parameter(double along) const {
  along = std::clamp(along, 0.0, length());
  const auto next = std::upper_bound(lengths_.begin(), lengths_.end() - 1, along);
  const auto i = static_cast<size_t>(next - lengths_.begin()) - 1;
  if (i + 1 == lengths_.size()) return 1;
  double low = parameters_[i], high = parameters_[i + 1];
  double t = low + (high - low) * (along - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
  for (int step = 0; step < 60; ++step) {  // Newton's method, safeguarded by bisection
    const double miss = length_to(t) - along;
    (miss > 0 ? high : low) = t;
    const double speed = curve_.derivative(t).length();
    if (std::fabs(miss) <= 1e-14 * length() || high - low <= 1e-16) break;
    const double newton = t - miss / speed;
    t = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return t;
}

Bezier drooping(double length, double lean, double tip, double azimuth, double stiff) {
  if (!(length > 0) || !std::isfinite(length) || !(stiff > 0 && stiff < 1))
    throw Error(ErrorCode::bad_input,
                "invalid stem: the length must be above 0 and the stiff fraction between 0 and 1");
  const auto way = [&](double angle) {
    const double out = maths::sin(angle);
    return Vec3d(out * maths::cos(azimuth), maths::cos(angle), -out * maths::sin(azimuth));
  };
  // The middle leg has turned by less than half: the thinner end bends more easily.
  constexpr double kMiddle = 0.4, kMiddleShare = 0.55;
  Bezier curve{{Vec3d(0), way(lean) * stiff, Vec3d(0), Vec3d(0)}};
  curve.control[2] =
      curve.control[1] + way(lean + kMiddle * (tip - lean)) * ((1 - stiff) * kMiddleShare);
  curve.control[3] = curve.control[2] + way(tip) * ((1 - stiff) * (1 - kMiddleShare));
  const double scale = length / ArcBezier(curve).length();
  for (Vec3d& p : curve.control) p *= scale;
  return curve;
}

}  // namespace vug
