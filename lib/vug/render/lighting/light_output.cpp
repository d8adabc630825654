// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/render/lighting/light_output.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
Rgb finite_radiance(const Vec3d& radiance, const std::string& hint) {
  const double most = std::max({radiance.x, radiance.y, radiance.z});
  if (most <= kMaxRadiance) return Rgb(radiance);
  throw Error(ErrorCode::bad_input,
              fmt::format("a radiance of {:.3g} W/sr/m^2 exceeds the maximum of {:.0e}", most,
                          kMaxRadiance),
              {}, hint);
}

std::string LightOutputParams::fault() const {
  if (power && lumen) return "give the power of a light in watts or in lumen, not in both";
  if ((power || lumen) && !(luminance(radiance) > 0))
    return "a light with a power needs a radiance above 0, which gives its colour";
  if (!only.empty() && !except.empty()) return "a light takes 'only' or 'except', not both";
  return "";
}

Vec3d LightOutputParams::tinted_radiance() const {
  return temperature ? radiance * blackbody(*temperature) : radiance;
}

std::optional<double> LightOutputParams::watts() const {
  if (lumen) return *lumen / kLumenPerWatt;
  return power;
}

Rgb LightOutputParams::radiance_for(double watts_per_radiance) const {
  const Vec3d colour = tinted_radiance();
  const auto all = watts();
  if (!all) return finite_radiance(colour);
  return finite_radiance(colour * (*all / (watts_per_radiance * luminance(colour))),
                         "the light is too small for its power");
}

}  // namespace vug::render
