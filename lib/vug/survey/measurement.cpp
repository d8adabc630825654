// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/measurement.h>

#include <vug/base/maths.h>

#include <algorithm>
#include <cmath>

namespace vug::survey {
namespace {

double square(double x) { return x * x; }

/// The covariance of a horizontal distance with variance `along` in the direction (s, c), of an
/// error across it with variance `across`, and of a height.
Covariance horizontal_covariance(double s, double c, double along, double across) {
  return {.xx = s * s * along + c * c * across,
          .yy = c * c * along + s * s * across,
          .xy = s * c * (along - across)};
}

void add_position(Covariance& covariance, double position) {
  covariance.xx += position / 3;
  covariance.yy += position / 3;
  covariance.zz += position / 3;
}

}  // namespace

Averaged average(const Reading& fore, const Reading& back) {
  const double sum = fore.variance + back.variance;
  return {{(fore.value * back.variance + back.value * fore.variance) / sum, sum / 4},
          std::fabs(fore.value - back.value) / std::sqrt(sum)};
}

Averaged average_bearing(const Reading& fore, const Reading& back) {
  const double apart = std::remainder(back.value - fore.value, 2 * kPi);
  return average(fore, {fore.value + apart, back.variance});
}

MeasuredVector turned(const MeasuredVector& leg, double angle) {
  const double s = maths::sin(angle), c = maths::cos(angle);
  const Vec3d& p = leg.vector;
  const Covariance& v = leg.covariance;
  return {{c * p.x + s * p.y, c * p.y - s * p.x, p.z},
          {.xx = c * c * v.xx + s * s * v.yy + 2 * s * c * v.xy,
           .yy = s * s * v.xx + c * c * v.yy - 2 * s * c * v.xy,
           .zz = v.zz,
           .xy = s * c * (v.yy - v.xx) + (c * c - s * s) * v.xy,
           .yz = c * v.yz - s * v.zx,
           .zx = c * v.zx + s * v.yz}};
}

MeasuredVector polar_leg(const Reading& tape, const Reading& bearing, const Reading& gradient,
                         double position) {
  const double s = maths::sin(bearing.value), c = maths::cos(bearing.value);
  const double sine = maths::sin(gradient.value), cosine = maths::cos(gradient.value);
  const double length = tape.value, height = length * sine, distance = length * cosine;
  Covariance v = horizontal_covariance(
      s, c, cosine * cosine * tape.variance + height * height * gradient.variance,
      distance * distance * bearing.variance);
  const double mixed = sine * cosine * (tape.variance - length * length * gradient.variance);
  v.zz = sine * sine * tape.variance + distance * distance * gradient.variance;
  v.zx = s * mixed;
  v.yz = c * mixed;
  add_position(v, position);
  return {{s * distance, c * distance, height}, v};
}

MeasuredVector unlevelled_leg(const Reading& tape, const Reading& bearing, double position) {
  MeasuredVector leg = polar_leg(tape, bearing, {}, position);
  leg.covariance.zz = position / 3 + square(tape.value) / 10;
  leg.covariance.yz = leg.covariance.zx = 0;
  return leg;
}

MeasuredVector plumb_leg(const Reading& height, double plumb, double position) {
  Covariance v;
  v.xx = v.yy = square(height.value) * plumb;
  v.zz = height.variance;
  add_position(v, position);
  return {{0, 0, height.value}, v};
}

MeasuredVector diving_leg(const Reading& tape, const Reading& bearing, const Reading& rise,
                          double position) {
  const double s = maths::sin(bearing.value), c = maths::cos(bearing.value);
  const double squared = square(tape.value) - square(rise.value);
  if (squared <= 0) {
    const Reading length{std::copysign(tape.value, rise.value), tape.variance};
    return plumb_leg(average(rise, length).reading, 0, position);
  }
  // The horizontal distance is uncertain if the leg is nearly vertical.
  const double distance = std::sqrt(squared);
  const double floor = std::max(squared, tape.variance + rise.variance);
  const double along =
      (square(tape.value) * tape.variance + square(rise.value) * rise.variance) / floor;
  Covariance v = horizontal_covariance(s, c, along, squared * bearing.variance);
  const double mixed = -distance * rise.value * rise.variance / floor;
  v.zz = rise.variance;
  v.zx = s * mixed;
  v.yz = c * mixed;
  add_position(v, position);
  return {{s * distance, c * distance, rise.value}, v};
}

MeasuredVector cylindrical_leg(const Reading& distance, const Reading& bearing, const Reading& rise,
                               double position) {
  const double s = maths::sin(bearing.value), c = maths::cos(bearing.value);
  Covariance v =
      horizontal_covariance(s, c, distance.variance, square(distance.value) * bearing.variance);
  v.zz = rise.variance;
  add_position(v, position);
  return {{s * distance.value, c * distance.value, rise.value}, v};
}

}  // namespace vug::survey
