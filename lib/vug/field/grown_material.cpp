// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/grown_material.h>
#include <vug/field/material_source.h>
#include <vug/field/registry.h>

#include <fmt/format.h>

namespace vug::field {
namespace {

/// A layer is this thick in metres where half of the material is its own.
constexpr double kThinnestLayer = 0.001;

}  // namespace

Field of_material(const Field& solid, const RockMaterialPtr& material) {
  if (!material) return solid;
  return make("made_of",
              {{"field", as_value(solid)}, {"of", ValueTraits<RockMaterialPtr>::write(material)}});
}

Field grown_on(const Field& rock, const Field& with_layer, const RockMaterialPtr& material) {
  if (!material) return with_layer;
  if (const std::string fault = growth_fault(rock, material); !fault.empty())
    throw Error(ErrorCode::bad_input, fault, {},
                "give the rock one: made_of(rock, of: \"limestone\")");
  const Field core = make("offset", {{"field", as_value(rock)}, {"by", 0.5 * kThinnestLayer}});
  return make("host_rock", {{"field", as_value(with_layer)},
                            {"of", ValueTraits<RockMaterialPtr>::write(material)},
                            {"bodies", List{as_value(core)}},
                            {"contact", kThinnestLayer}});
}

std::string growth_fault(const Field& rock, const RockMaterialPtr& material) {
  if (!material || !materials_of(rock).empty()) return {};
  return fmt::format("the speleothems are made of '{}', but the rock has no material",
                     material->name);
}

}  // namespace vug::field
