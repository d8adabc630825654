// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/gltf_material.h>

#include <algorithm>

namespace vug::exchange {
namespace {

using tinygltf::Value;

Value object(std::initializer_list<std::pair<const std::string, double>> numbers) {
  Value::Object out;
  for (const auto& [name, number] : numbers) out.emplace(name, Value(number));
  return Value(out);
}

std::vector<double> list(const Vec3d& v) { return {v.x, v.y, v.z}; }

}  // namespace

Value gltf_value(const Vec3d& v) { return Value(Value::Array{Value(v.x), Value(v.y), Value(v.z)}); }

tinygltf::Material gltf_material(const Prototype& prototype, double emission_scale) {
  const Look& look = prototype.look;
  tinygltf::Material out;
  out.name = prototype.material;
  out.doubleSided = look.thin;
  // Varying opacity is the alpha of COLOR_0.
  const bool opacity_varies = mesh::find_attribute(*prototype.mesh, "opacity", 1) != nullptr;
  const bool colored =
      opacity_varies || mesh::find_attribute(*prototype.mesh, mesh::kColour, 3) != nullptr;
  out.pbrMetallicRoughness.baseColorFactor = {1, 1, 1, 1};
  if (!colored)
    for (int c = 0; c < 3; ++c)
      out.pbrMetallicRoughness.baseColorFactor[static_cast<size_t>(c)] =
          std::clamp(look.base_color[c], 0.0, 1.0);
  if (!opacity_varies)
    out.pbrMetallicRoughness.baseColorFactor[3] = std::clamp(look.opacity, 0.0, 1.0);
  if (opacity_varies || look.opacity < 1) out.alphaMode = "BLEND";
  out.pbrMetallicRoughness.metallicFactor = look.metallic;
  out.pbrMetallicRoughness.roughnessFactor = look.roughness;
  if (look.specular != 1)
    out.extensions["KHR_materials_specular"] = object({{"specularFactor", look.specular}});
  if (look.ior != 1.5) out.extensions["KHR_materials_ior"] = object({{"ior", look.ior}});
  if (look.wetness > 0)
    out.extensions["KHR_materials_clearcoat"] = object(
        {{"clearcoatFactor", look.wetness}, {"clearcoatRoughnessFactor", look.coat_roughness}});
  if (look.transmission > 0)
    out.extensions["KHR_materials_transmission"] =
        object({{"transmissionFactor", look.transmission}});
  if (look.through != Vec3d(0.0))
    out.extras = Value(Value::Object{{"vug:through", gltf_value(look.through)}});
  const Vec3d light = look.emission * emission_scale;
  if (const double most = std::max({light.x, light.y, light.z}); most > 0) {
    out.emissiveFactor = list(light / most);
    if (most != 1)
      out.extensions["KHR_materials_emissive_strength"] = object({{"emissiveStrength", most}});
  }
  return out;
}

}  // namespace vug::exchange
