#include <vug/base/maths.h>
#include <vug/render/lamp.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

double luminance_of(const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

}  // namespace

std::string LampParams::fault() const {
  if (power && lumen) return "a lamp's light is told in watts or in lumen, not in both";
  if ((power || lumen) && !(luminance_of(radiance) > 0))
    return "a lamp of black radiance has no colour that could be brought to a power";
  if (!only.empty() && !except.empty()) return "a light has 'only' or 'except', not both";
  return "";
}

Vec3d LampParams::tinted() const {
  return temperature ? radiance * blackbody(*temperature) : radiance;
}

std::optional<double> LampParams::watts() const {
  if (lumen) return *lumen / kLumenPerWatt;
  return power;
}

Rgb LampParams::radiance_of(double watts_per_radiance) const {
  const Vec3d colour = tinted();
  const auto all = watts();
  return Rgb(all ? colour * (*all / (watts_per_radiance * luminance_of(colour))) : colour);
}

}  // namespace vug::render
