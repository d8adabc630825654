// How bright a lamp is and what colour it has: parameters that all kinds of lamps share.
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

  std::string fault() const;  ///< Empty, or a sentence on what does not fit together.
  /// The colour, with the luminance that `radiance` has.
  Vec3d tinted_radiance() const;
  /// Radiance of a lamp that sends out this many watts for each W/sr/m^2 of it.
  Rgb radiance_for(double watts_per_radiance) const;
  /// Total light that was asked for in watts of luminance, if any was.
  std::optional<double> watts() const;
};

/// What the parameters of a kind of light say of it beside its shape and brightness.
inline const LightLinking& linking_of(const LightLinking& params) { return params; }

/// W/sr/m^2: what leaves single precision room for areas, for squares of distances and for sums.
inline constexpr double kMaxRadiance = 1e30;

/// The radiance in single precision. Error(bad_input) with `hint` where it is so large that sums of
/// it would not be finite there.
Rgb finite_radiance(const Vec3d& radiance, const std::string& hint = {});

/// The parameters of a kind P that derives from LightLinking.
template <class P>
void describe_linking(Schema<P>& s) {
  s.param("group", &LightLinking::group, {.doc = "Group of the picture's layers of lights."})
      .param("only", &LightLinking::only, {.doc = "Names of the objects it lights; else all."})
      .param("except", &LightLinking::except, {.doc = "Names of objects it does not light."});
}

/// The parameters of a kind P that derives from LightOutputParams.
template <class P>
void describe_light_output(Schema<P>& s) {
  s.param("radiance", &LightOutputParams::radiance,
          {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0})
      .param("visible", &LightOutputParams::visible,
             {.doc = "Whether the camera sees the lamp itself."})
      .param("temperature", &LightOutputParams::temperature,
             {.doc = "Gives it the colour of a black body at that many kelvin.",
              .min = 800,
              .max = 40000})
      .param("power", &LightOutputParams::power,
             {.doc = "All the light it sends out, in watts; radiance then tells only the colour.",
              .min = 0})
      .param("lumen", &LightOutputParams::lumen,
             {.doc = "The same in lumen; 179 of them to a watt.", .min = 0});
  describe_linking(s);
}

}  // namespace vug::render
