// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/speleothems/bisected.h>
#include <vug/field/speleothems/stalagmite_curve.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::field {
namespace {

/// Nodes and weights of Gauss's quadrature with five points on -1..1.
constexpr std::array<double, 5> kNodes = {-0.9061798459386640, -0.5384693101056831, 0,
                                          0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> kWeights = {0.2369268850561891, 0.4786286704993665,
                                            0.5688888888888889, 0.4786286704993665,
                                            0.2369268850561891};

}  // namespace

StalagmiteCurve::StalagmiteCurve(const StalagmiteForm& form)
    : form_(form),
      square_((form.radius * form.radius - form.landing * form.landing) / form.apex_cosine),
      first_(-maths::log(form.apex_cosine)) {}

double StalagmiteCurve::t_at(double r) const {
  const double cosine = form_.apex_cosine - (r * r - form_.landing * form_.landing) / square_;
  return -maths::log(std::min(cosine, form_.apex_cosine));
}

double StalagmiteCurve::radius_at(double t) const {
  const double fall = form_.apex_cosine - maths::exp(-t);
  return std::sqrt(form_.landing * form_.landing + square_ * std::max(fall, 0.0));
}

/// Over u = sqrt(t - first), in which the integrand stays finite at the apex.
double StalagmiteCurve::integral(double from, double to) const {
  const double a = std::sqrt(std::max(0.0, from - first_)),
               b = std::sqrt(std::max(0.0, to - first_));
  const int pieces = 1 + static_cast<int>(std::ceil(8 * (b - a)));
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double half = 0.5 * (b - a) / pieces, middle = a + (2 * i + 1) * half;
    for (size_t k = 0; k < kNodes.size(); ++k) {
      const double u = middle + half * kNodes[k], t = first_ + u * u;
      const double cosine = maths::exp(-t);
      sum += half * kWeights[k] * u * std::sqrt(1 - cosine * cosine) * square_ / radius_at(t);
    }
  }
  return sum;
}

double StalagmiteCurve::depth_at(double r) const {
  if (r <= form_.landing) {  // The top is a plane or a cone.
    const double sine = std::sqrt(1 - form_.apex_cosine * form_.apex_cosine);
    return r * sine / form_.apex_cosine;
  }
  return depth_at(form_.landing) + integral(first_, t_at(r));
}

std::vector<Vec2d> StalagmiteCurve::points(double depth, int count) const {
  // Far down, the depth grows by R^2 / (2 radius) for each unit of t.
  const double top = depth_at(form_.landing);
  double last = first_ + 1;
  while (top + integral(first_, last) < depth) last = first_ + 2 * (last - first_);
  last = bisected(first_, last, depth - top, [this](double t) { return integral(first_, t); });
  std::vector<Vec2d> out = {Vec2d(0, 0)};
  if (form_.landing > 0) out.emplace_back(form_.landing, top);
  double below = top, t = first_;
  for (int i = 1; i < count; ++i) {
    const double part = static_cast<double>(i) / (count - 1);
    const double next = first_ + (last - first_) * part * part;
    below += integral(t, next);
    t = next;
    out.emplace_back(radius_at(t), below);
  }
  return out;
}

}  // namespace vug::field
