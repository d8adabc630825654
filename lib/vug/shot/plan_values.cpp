// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/plan_values.h>

namespace vug {

std::optional<shot::MeshOrLevelSet> ValueTraits<shot::MeshOrLevelSet>::read(const Value& value) {
  if (const auto* mesh = value.object<shot::MeshPtr>()) return shot::MeshOrLevelSet{*mesh};
  const auto* volume = value.object<shot::VolumePtr>();
  if (!volume || (*volume)->fog) return std::nullopt;
  return shot::MeshOrLevelSet{shot::plain_mesh(*volume)};
}

}  // namespace vug
