// How bright a lamp is and what colour it has: parameters that all kinds of lamps share.
#pragma once

#include <vug/base/schema.h>
#include <vug/render/lighting/blackbody.h>
#include <vug/render/light.h>

#include <optional>
#include <string>

namespace vug::render {

struct LampParams : LightNotes {
  Vec3d radiance{1, 1, 1};
  bool visible = true;
  std::optional<double> temperature, power, lumen;

  std::string fault() const;  ///< Empty, or a sentence on what does not fit together.
  /// The colour, with the luminance that `radiance` has.
  Vec3d tinted() const;
  /// Radiance of a lamp that sends out this many watts for each W/sr/m^2 of it.
  Rgb radiance_of(double watts_per_radiance) const;
  /// Total light that was asked for in watts of luminance, if any was.
  std::optional<double> watts() const;
};

/// What the parameters of a kind of light say of it beside its shape and brightness.
inline const LightNotes& notes_of(const LightNotes& params) { return params; }

/// W/sr/m^2: what leaves single precision room for areas, for squares of distances and for sums.
inline constexpr double kMostRadiance = 1e30;

/// The radiance in single precision. Error(bad_input) with `hint` where it is so large that sums of
/// it would not be finite there.
Rgb finite_radiance(const Vec3d& radiance, const std::string& hint = {});

/// The parameters of a kind P that derives from LightNotes.
template <class P>
void describe_notes(Schema<P>& s) {
  s.param("group", &LightNotes::group, {.doc = "Group of the picture's layers of lights."})
      .param("only", &LightNotes::only, {.doc = "Names of the objects it lights; else all."})
      .param("except", &LightNotes::except, {.doc = "Names of objects it does not light."});
}

/// The parameters of a kind P that derives from LampParams.
template <class P>
void describe_lamp(Schema<P>& s) {
  s.param("radiance", &LampParams::radiance,
          {.doc = "Radiance of red, green, blue in W/sr/m^2.", .min = 0})
      .param("visible", &LampParams::visible, {.doc = "Whether the camera sees the lamp itself."})
      .param("temperature", &LampParams::temperature,
             {.doc = "Gives it the colour of a black body at that many kelvin.",
              .min = 800,
              .max = 40000})
      .param("power", &LampParams::power,
             {.doc = "All the light it sends out, in watts; radiance then tells only the colour.",
              .min = 0})
      .param("lumen", &LampParams::lumen,
             {.doc = "The same in lumen; 179 of them to a watt.", .min = 0});
  describe_notes(s);
}

}  // namespace vug::render
