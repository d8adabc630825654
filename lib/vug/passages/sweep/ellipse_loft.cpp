// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/sweep/ellipse_loft_sample.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace vug::passages {
namespace {

constexpr double kWidestTurn = 0.5;  // Radians.

bool circle(double a, double b) { return std::fabs(a - b) <= 1e-12 * a; }

}  // namespace

std::optional<EllipseLoft> EllipseLoft::between(Vec3d from_a, Vec3d from_b, Vec3d to_a,
                                                Vec3d to_b) {
  EllipseLoft out;
  const double a = to_a.length(), b = to_b.length();
  out.a0_ = from_a.length();
  out.b0_ = from_b.length();
  out.a1_ = a - out.a0_;
  out.b1_ = b - out.b0_;
  const bool round_from = circle(out.a0_, out.b0_), round_to = circle(a, b);
  out.round_ = round_from && round_to;
  if (round_from && !round_to) {
    from_a = to_a;
    from_b = to_b;
  } else if (round_to) {
    to_a = from_a;
  }
  out.first_ = from_a.normalized();
  out.second_ = from_b.normalized();
  const Vec3d turned = to_a.normalized();
  double along = turned.dot(out.first_), aside = turned.dot(out.second_);
  if (along < 0) {  // An ellipse equals itself after half a turn.
    along = -along;
    aside = -aside;
  }
  const double turn = maths::atan2(aside, along);
  if (std::fabs(turn) > kWidestTurn) return std::nullopt;
  if (std::fabs(turn) > 1e-9) {
    out.turn_ = turn;
    out.cosine_ = maths::cos(turn);
    out.sine_ = maths::sin(turn);
  }
  const auto ratio = [](double one, double other) {
    return std::max(one, other) / std::min(one, other);
  };
  out.steps_ = ellipse_steps(std::max(ratio(out.a0_, out.b0_), ratio(a, b)));
  return out;
}

void EllipseLoft::samples(const Pack* u, const Pack* v, const Pack* t, int count, Sample<Pack>* out,
                          field::Scratch& scratch) const {
  const EllipseLoft loft = *this;  // Packs may alias members, but not a local copy.
  if (round_) {
    for (int i = 0; i < count; ++i)
      ::new (out + i) Sample<Pack>(loft.sample_circle(u[i], v[i], t[i]));
    return;
  }
  field::Scratch::Frame frame(scratch);
  const auto size = static_cast<size_t>(count);
  auto* at = frame.take<Slice<Pack>>(size);
  auto* roots = frame.take<EllipseRoot<Pack>>(size);
  int* open = frame.take<int>(size);
  for (int i = 0; i < count; ++i) {
    ::new (at + i) Slice<Pack>(loft.slice(u[i], v[i], t[i]));
    ::new (roots + i) EllipseRoot<Pack>(at[i].a, at[i].b, at[i].x, at[i].y);
    open[i] = i;
  }
  int left = count;
  for (int step = 0; step < steps_ && left > 0; ++step) {
    int still = 0;
    for (int i = 0; i < left; ++i) {
      const int k = open[i];
      open[still] = k;
      still += roots[k].step();
    }
    left = still;
  }
  for (int i = 0; i < count; ++i)
    ::new (out + i) Sample<Pack>(loft.finish(at[i], roots[i].distance()));
}

/// With h the support function and c, s the normal, the square of the ratio of h + d to the support
/// function of the half-axes a + d and b + d is 1 + 2 d (h - a c^2 - b s^2) / (the latter's
/// square), and that difference is at most (a - b)^2 / (8 min(a, b)). Turns move the outline by
/// `bulge`.
std::pair<double, double> EllipseLoft::grown_axes(double distance) const {
  const double a = std::max(a0_, a0_ + a1_), b = std::max(b0_, b0_ + b1_), d = distance + bulge();
  const double small = std::min(a, b), gap = (a - b) / (small + d);
  const double factor = std::sqrt(1 + d * gap * gap / (4 * small)), circle = std::max(a, b) + d;
  if (factor * (small + d) >= circle) return {circle, circle};
  return {factor * (a + d), factor * (b + d)};
}

double EllipseLoft::slope() const {
  const double oblong = std::max(std::fabs(a0_ - b0_), std::fabs(a0_ + a1_ - b0_ - b1_));
  const double speed = turn_ == 0 ? 0 : 2 * std::fabs(sine_) / (1 + cosine_);
  return std::max(std::fabs(a1_), std::fabs(b1_)) + oblong * speed;
}

double EllipseLoft::depth() const {
  return std::min(std::max(a0_, a0_ + a1_), std::max(b0_, b0_ + b1_));
}

double EllipseLoft::bulge() const {
  const double oblong = std::max(std::fabs(a0_ - b0_), std::fabs(a0_ + a1_ - b0_ - b1_));
  return oblong * std::fabs(turn_);
}

}  // namespace vug::passages
