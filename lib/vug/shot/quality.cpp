// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/quality.h>
#include <vug/shot/render_settings.h>

#include <algorithm>

namespace vug::shot {

const std::vector<std::pair<std::string, Quality>>& quality_names() {
  static const std::vector<std::pair<std::string, Quality>> names = {
      {"draft", Quality::draft}, {"look", Quality::look}, {"final", Quality::final}};
  return names;
}

QualityTargets quality_targets(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {16, 0, true};
    case Quality::look:
      return {128, 0.08, true};
    case Quality::final:
      return {4096, 0.02, false};
    case Quality::unstated:
      break;
  }
  return {RenderSettings().spp, 0, false};
}

void apply_quality(RenderSettings& settings, const std::vector<std::string>& stated,
                   const NamedValues& overrides) {
  // A setting counts from the level where it has a value: 2 override, 1 scene, 0 none.
  const auto level = [&](const char* name) {
    const bool replaced = std::any_of(overrides.begin(), overrides.end(), [&](const auto& each) {
      return each.first == name && !each.second.empty();
    });
    if (replaced) return 2;
    return std::find(stated.begin(), stated.end(), name) == stated.end() ? 0 : 1;
  };
  if (settings.quality == Quality::unstated) {
    if (level("spp") > 0 || level("noise") > 0) return;
    settings.quality = Quality::look;
  }
  const QualityTargets targets = quality_targets(settings.quality);
  const int least = std::max(1, level("quality"));
  const bool exact = level("spp") >= least;
  if (!exact) settings.spp = targets.spp;
  if (level("noise") < least) settings.noise = exact ? 0 : targets.noise;
  if (level("denoise") < least) settings.denoise = targets.denoise;
}

}  // namespace vug::shot
