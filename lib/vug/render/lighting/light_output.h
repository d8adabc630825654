// SPDX-License-Identifier: Apache-2.0
// Brightness, colour and linking of a light: the parameters that all lights of finite size share.
#pragma once

#include <vug/base/schema.h>
#include <vug/render/light.h>
#include <vug/render/lighting/blackbody.h>

#include <optional>
#include <string>

namespace vug::render {

struct LightOutputParams : LightLinking {
  Vec3d radiance{1, 1, 1};
  bool visible = true;
  std::optional<double> temperature, power, lumen;

  std::string fault()
      const;  ///< Empty, or an error message about parameters that contradict each other.
  /// `radiance` tinted by `temperature`; keeps the luminance of `radiance`.
  Vec3d tinted_radiance() const;
  /// Radiance of a light that emits `watts_per_radiance` watts for each W/sr/m^2.
  Rgb radiance_for(double watts_per_radiance) const;
  /// Requested total power in watts of luminance, if the scene gives one.
  std::optional<double> watts() const;
};

/// The light linking part of the parameters of a kind of light.
inline const LightLinking& linking_of(const LightLinking& params) { return params; }

/// Largest radiance in W/sr/m^2. It leaves room in single precision for areas, squared distances
/// and sums.
inline constexpr double kMaxRadiance = 1e30;

/// Converts the radiance to single precision. Error(bad_input) with `hint` if it exceeds
/// kMaxRadiance, so that sums would not be finite.
Rgb finite_radiance(const Vec3d& radiance, const std::string& hint = {});

/// Adds the parameters of a kind P that derives from LightLinking.
template <class P>
void describe_linking(Schema<P>& s) {
  s.param("group", &LightLinking::group, {.doc = "Group in the picture's light AOVs."})
      .param("only", &LightLinking::only,
             {.doc = "Names of the only objects that it lights; all objects when not given."})
      .param("except", &LightLinking::except, {.doc = "Names of objects that it does not light."});
}

/// Adds the parameters of a kind P that derives from LightOutputParams.
template <class P>
void describe_light_output(Schema<P>& s) {
  s.param("radiance", &LightOutputParams::radiance,
          {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0})
      .param("visible", &LightOutputParams::visible,
             {.doc = "Whether the camera sees the light itself."})
      .param("temperature", &LightOutputParams::temperature,
             {.doc = "Tints it with the colour of a black body at this temperature in kelvin.",
              .dimension = Dimension::temperature,
              .min = kCoolestBlackbody,
              .max = kHottestBlackbody})
      .param("power", &LightOutputParams::power,
             {.doc = "Total power in watts; radiance then gives only the colour.",
              .dimension = Dimension::power,
              .min = 0})
      .param("lumen", &LightOutputParams::lumen,
             {.doc = "Total power in lumen; 179 lumen are one watt.",
              .dimension = Dimension::luminous_flux,
              .min = 0});
  describe_linking(s);
}

}  // namespace vug::render
