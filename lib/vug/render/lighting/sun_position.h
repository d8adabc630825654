// SPDX-License-Identifier: Apache-2.0
// Position of the sun and its irradiance after atmospheric extinction.
#pragma once

#include <vug/base/schema.h>
#include <vug/base/vec.h>

#include <optional>
#include <string>

namespace vug::render {

/// Given by angles, or by place and time. North is -z, east x, up y.
struct SunParams {
  std::optional<double> elevation, azimuth;
  std::optional<double> latitude, day, hour;

  std::string fault() const;  ///< Empty, or an error message if both are given.

  /// Unit vector towards the sun.
  Vec3d direction() const;
};

/// Adds the parameters of a kind P that derives from SunParams.
template <class P>
void describe_sun(Schema<P>& s) {
  s.param("elevation", &SunParams::elevation,
          {.doc = "Height of the sun above the horizon; default 45deg.",
           .dimension = Dimension::angle,
           .min = -kPi / 2,
           .max = kPi / 2})
      .param("azimuth", &SunParams::azimuth,
             {.doc = "Azimuth from north (-z) over east (x); default 135deg.",
              .dimension = Dimension::angle})
      .param("latitude", &SunParams::latitude,
             {.doc = "Geographic latitude; day and hour then give the sun's position.",
              .dimension = Dimension::angle,
              .min = -kPi / 2,
              .max = kPi / 2})
      .param("day", &SunParams::day,
             {.doc = "Day of the year, 1 to 365; default 172.", .min = 1, .max = 366})
      .param("hour", &SunParams::hour,
             {.doc = "Solar time in hours: the sun is highest at 12; default 10.",
              .min = 0,
              .max = 24});
}

/// Irradiance (W/m^2, red, green, blue) after the atmosphere on a surface that faces the sun; 0
/// below the horizon. The extraterrestrial sunlight of 133 klx in total is attenuated in each band
/// by molecules, dust and ozone with the formulas of Preetham, Shirley, Smits 1999, "A practical
/// analytic model for daylight", appendix A.1 (cite preetham1999), at 615, 535 and 450 nm.
Vec3d sun_irradiance(const Vec3d& to_sun, double turbidity);

}  // namespace vug::render
