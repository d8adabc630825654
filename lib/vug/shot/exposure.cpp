// SPDX-License-Identifier: Apache-2.0
#include <vug/base/log2.h>
#include <vug/render/lighting/blackbody.h>
#include <vug/shot/exposure.h>

#include <algorithm>

namespace vug::shot {
namespace {

constexpr double kSaturation = 1.2;  // cd/m^2 at EV100 0

}  // namespace

const std::vector<std::string>& exposure_names() {
  static const std::vector<std::string> names = {"auto", "locked", "physical"};
  return names;
}

double physical_stops(const PhysicalExposure& camera) {
  const double ev100 =
      maths::log2(camera.f_number * camera.f_number / camera.time * 100 / camera.iso);
  return maths::log2(render::kLumenPerWatt / kSaturation) - ev100;
}

}  // namespace vug::shot

namespace vug {

std::optional<shot::Exposure> ValueTraits<shot::Exposure>::read(const Value& v) {
  using Mode = shot::Exposure::Mode;
  if (const auto* stops = v.get<Number>()) return shot::Exposure{Mode::stops, stops->value};
  const auto* given = v.get<Value::Name>();
  const auto& names = shot::exposure_names();
  const auto found = given ? std::find(names.begin(), names.end(), given->text) : names.end();
  if (found == names.end()) return std::nullopt;
  return shot::Exposure{static_cast<Mode>(1 + (found - names.begin()))};
}

Value ValueTraits<shot::Exposure>::write(const shot::Exposure& exposure) {
  if (exposure.mode == shot::Exposure::Mode::stops) return exposure.stops;
  return Value::Name{shot::exposure_names()[static_cast<size_t>(exposure.mode) - 1]};
}

}  // namespace vug
