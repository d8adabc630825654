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
              fmt::format("a radiance of {:.3g} W/sr/m^2 is more than can be computed with: {:.0e} "
                          "at most",
                          most, kMaxRadiance),
              {}, hint);
}

std::string LightOutputParams::fault() const {
  if (power && lumen) return "a lamp's light is told in watts or in lumen, not in both";
  if ((power || lumen) && !(luminance(radiance) > 0))
    return "a lamp of black radiance has no colour that could be brought to a power";
  if (!only.empty() && !except.empty()) return "a light has 'only' or 'except', not both";
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
                         "the lamp is too small for its power");
}

}  // namespace vug::render
