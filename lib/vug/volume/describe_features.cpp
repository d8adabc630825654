// SPDX-License-Identifier: Apache-2.0
// The text of a list of small features for warnings and summaries.
#include <vug/base/pluralize.h>
#include <vug/volume/small_features.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::volume {

std::string to_string(SmallFeature::Kind kind) {
  return kind == SmallFeature::Kind::bubble  ? "bubble"
         : kind == SmallFeature::Kind::crumb ? "crumb"
                                             : "handle";
}

std::string describe(const std::vector<SmallFeature>& features) {
  using Kind = SmallFeature::Kind;
  std::string text;
  for (const Kind kind : {Kind::bubble, Kind::crumb, Kind::handle}) {
    const auto count = std::count_if(features.begin(), features.end(),
                                     [&](const SmallFeature& each) { return each.kind == kind; });
    if (count) text += pluralize(static_cast<size_t>(count), to_string(kind)) + ", ";
  }
  constexpr size_t kMost = 3;
  for (size_t i = 0; i < std::min(kMost, features.size()); ++i) {
    const Vec3d& at = features[i].at;
    text += fmt::format("{}({:.6g}, {:.6g}, {:.6g})", i ? ", " : "at ", at.x, at.y, at.z);
  }
  if (features.size() > kMost)
    text += fmt::format(" and {}", pluralize(features.size() - kMost, "other place"));
  return text;
}

}  // namespace vug::volume
