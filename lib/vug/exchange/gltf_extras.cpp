#include <vug/exchange/gltf_extras.h>
#include <vug/exchange/gltf_material.h>
#include <vug/exchange/place.h>

namespace vug::exchange {

using tinygltf::Value;

Value gltf_sky(const Lamp& dome, const std::string& picture) {
  Value::Object out = {{"name", Value(dome.name)}, {"radiance", gltf_value(dome.radiance)}};
  const Placement at = placement(dome.place).value_or(Placement());
  Value::Array turn;
  for (const double part : at.turn) turn.emplace_back(part);
  if (at.turn != Placement().turn) out.emplace("rotation", Value(turn));
  if (!picture.empty()) out.emplace("file", Value(picture));
  return Value(out);
}

Value gltf_volume(const Volume& volume) {
  Value::Array grids;
  for (const VolumeGrid& grid : volume.grids) grids.emplace_back(grid.name);
  Value::Object out = {
      {"name", Value(volume.name)}, {"file", Value(volume.file)}, {"grids", Value(grids)}};
  if (const auto& cloud = volume.cloud) {
    out.emplace("extinction", Value(cloud->extinction));
    out.emplace("albedo", gltf_value(cloud->albedo));
    out.emplace("forward", Value(cloud->forward));
    out.emplace("emission", gltf_value(cloud->emission));
    out.emplace("heat", Value(cloud->heat));
  }
  return Value(out);
}

}  // namespace vug::exchange
