// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/render/lighting/light_output.h>
#include <vug/render/lighting/sun_position.h>

#include <algorithm>

namespace vug::render {

std::string SunParams::fault() const {
  if (latitude && (elevation || azimuth))
    return "give the sun's position by its angles or by latitude, day and hour, not by both";
  if (!latitude && (day || hour)) return "'day' and 'hour' need 'latitude'";
  return "";
}

Vec3d SunParams::direction() const {
  const double up = elevation.value_or(45 * kPi / 180), round = azimuth.value_or(135 * kPi / 180);
  if (latitude) {
    // Declination from the days since the winter solstice, and the hour angle.
    const double tilt = -23.44 * kPi / 180 * maths::cos(2 * kPi / 365 * (day.value_or(172) + 10));
    const double turned = (hour.value_or(10) - 12) * kPi / 12;
    const double sine = maths::sin(*latitude) * maths::sin(tilt) +
                        maths::cos(*latitude) * maths::cos(tilt) * maths::cos(turned);
    const double east = -maths::cos(tilt) * maths::sin(turned);
    const double north = maths::cos(*latitude) * maths::sin(tilt) -
                         maths::sin(*latitude) * maths::cos(tilt) * maths::cos(turned);
    return Vec3d(east, sine, -north).normalized();
  }
  return {maths::cos(up) * maths::sin(round), maths::sin(up), -maths::cos(up) * maths::cos(round)};
}

Vec3d sun_irradiance(const Vec3d& to_sun, double turbidity) {
  if (!(to_sun.y > 0)) return Vec3d(0.0);
  const double zenith = maths::acos(std::min(1.0, to_sun.y));
  const double mass = 1 / (to_sun.y + 0.15 * maths::pow(93.885 - zenith * 180 / kPi, -1.253));
  const double dust = std::max(0.0, 0.04608 * turbidity - 0.04586);
  const double wavelengths[3] = {0.615, 0.535, 0.450};  // micrometres
  const double ozone[3] = {0.118, 0.075, 0.003};        // 1/cm, in a layer of 0.35 cm
  const Vec3d above = blackbody(5778) * (133000 / kLumenPerWatt);
  Vec3d out;
  for (int i = 0; i < 3; ++i) {
    const double depth = 0.008735 * maths::pow(wavelengths[i], -4.08) +
                         dust * maths::pow(wavelengths[i], -1.3) + ozone[i] * 0.35;
    out[i] = above[i] * maths::exp(-depth * mass);
  }
  return out;
}

}  // namespace vug::render
