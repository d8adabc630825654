// Where the sun stands and what the air leaves of its light.
#pragma once

#include <vug/base/schema.h>
#include <vug/base/vec.h>

#include <optional>
#include <string>

namespace vug::render {

/// By angles, or by place and time. North is -z, east x, up y.
struct SunParams {
  std::optional<double> elevation, azimuth;
  std::optional<double> latitude, day, hour;

  std::string fault() const;  ///< Empty, or a sentence on angles told in both ways.

  /// Unit, towards the sun.
  Vec3d direction() const;
};

/// The parameters of a kind P that derives from SunParams.
template <class P>
void describe_sun(Schema<P>& s) {
  s.param("elevation", &SunParams::elevation,
          {.doc = "Height of the sun above the horizon; without, 45deg.",
           .dimension = Dimension::angle,
           .min = -kPi / 2,
           .max = kPi / 2})
      .param(
          "azimuth", &SunParams::azimuth,
          {.doc = "From north (-z) over east (x); without, 135deg.", .dimension = Dimension::angle})
      .param("latitude", &SunParams::latitude,
             {.doc = "Of the place; then day and hour tell where the sun stands.",
              .dimension = Dimension::angle,
              .min = -kPi / 2,
              .max = kPi / 2})
      .param("day", &SunParams::day,
             {.doc = "Of the year, 1 to 365; without, 172.", .min = 1, .max = 366})
      .param(
          "hour", &SunParams::hour,
          {.doc = "Of the day by the sun: it is highest at 12; without, 10.", .min = 0, .max = 24});
}

/// Irradiance (W/m^2, red, green, blue) of a surface that faces the sun, after the air: the bands'
/// part of sunlight above the air, of 133 klx in all, less what molecules, dust and ozone take
/// away, by the formulas of Preetham, Shirley, Smits 1999, "A practical analytic model for
/// daylight", appendix A.1 (cite preetham1999), at 615, 535 and 450 nm. 0 below the horizon.
Vec3d sun_irradiance(const Vec3d& to_sun, double turbidity);

}  // namespace vug::render
