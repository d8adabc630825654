// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/passages/section.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::passages {

Interval Section::interval(Interval u, Interval v) const {
  const double centre = distance(u.middle(), v.middle());
  const double reach = 0.5 * std::sqrt(u.width() * u.width() + v.width() * v.width());
  return {centre - reach, centre + reach};
}

void require_valid(const SectionPlace& place) {
  if (place.width > 0 && place.height > 0 && std::isfinite(place.width) &&
      std::isfinite(place.height) && std::isfinite(place.curvature))
    return;
  throw Error(ErrorCode::bad_input,
              fmt::format("invalid section of width {} m, height {} m and curvature {} 1/m: sizes "
                          "must be above 0, and all values finite numbers",
                          place.width, place.height, place.curvature),
              {}, "check the widths and heights of the passage");
}

SectionFamilyPtr make_family(const std::string& name, const NamedValues& parameters) {
  return make_product(sections(), name, parameters);
}

}  // namespace vug::passages

namespace vug {

std::optional<passages::SectionFamilyPtr> ValueTraits<passages::SectionFamilyPtr>::read(
    const Value& v) {
  const auto* name = v.get<Value::Name>();
  if (!name || !find_kind(passages::sections(), name->text)) return ObjectTraits::read(v);
  return make_product(passages::sections(), name->text);
}

}  // namespace vug
