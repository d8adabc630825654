// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/gltf_extras.h>
#include <vug/exchange/gltf_material.h>
#include <vug/exchange/trs.h>

namespace vug::exchange {

using tinygltf::Value;

Value gltf_sky(const Light& dome, const std::string& picture) {
  Value::Object out = {{"name", Value(dome.name)}, {"radiance", gltf_value(dome.radiance)}};
  const TrsTransform at = decompose_trs(dome.place).value_or(TrsTransform());
  Value::Array turn;
  for (const double part : at.rotation) turn.emplace_back(part);
  if (at.rotation != TrsTransform().rotation) out.emplace("rotation", Value(turn));
  if (!picture.empty()) out.emplace("file", Value(picture));
  return Value(out);
}

Value gltf_volume(const Volume& volume) {
  Value::Array grids;
  for (const VolumeGrid& grid : volume.grids) grids.emplace_back(grid.name);
  Value::Object out = {
      {"name", Value(volume.name)}, {"file", Value(volume.file)}, {"grids", Value(grids)}};
  if (const auto& medium = volume.medium) {
    out.emplace("extinction", Value(medium->extinction));
    out.emplace("albedo", gltf_value(medium->albedo));
    out.emplace("forward", Value(medium->forward));
    out.emplace("emission", gltf_value(medium->emission));
    out.emplace("heat", Value(medium->heat));
  }
  return Value(out);
}

}  // namespace vug::exchange
