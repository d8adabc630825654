// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/pockettopo/shots.h>

#include <vug/base/maths.h>

#include <cmath>

namespace vug::survey::pockettopo {

Vec3d Shot::direction() const {
  const double level = maths::cos(gradient);
  return {level * maths::sin(bearing), level * maths::cos(bearing), maths::sin(gradient)};
}

Shot Shot::reversed() const { return {length, bearing + kPi, -gradient}; }

bool RepeatedShot::agrees(const Shot& shot) const {
  const Shot so_far = mean();
  const Vec3d a = so_far.direction(), b = shot.direction();
  const double angle = maths::atan2(a.cross(b).length(), a.dot(b));
  return std::fabs(shot.length - so_far.length) <= kLengthTolerance && angle <= kAngleTolerance;
}

void RepeatedShot::add(const Shot& shot) {
  if (count_++ == 0) first_ = shot;
  length_ += shot.length;
  sum_ += shot.direction();
}

Shot RepeatedShot::mean() const {
  if (count_ == 1) return first_;
  return {length_ / count_, maths::atan2(sum_.x, sum_.y),
          maths::atan2(sum_.z, std::sqrt(sum_.x * sum_.x + sum_.y * sum_.y))};
}

MeasuredVector RepeatedShot::measured(const Deviations& deviations) const {
  const auto reading = [&](double value, double deviation) {
    return Reading{value, deviation * deviation / count_};
  };
  const Shot shot = mean();
  return polar_leg(reading(shot.length, deviations.tape), reading(shot.bearing, deviations.compass),
                   reading(shot.gradient, deviations.clino),
                   deviations.position * deviations.position);
}

}  // namespace vug::survey::pockettopo
