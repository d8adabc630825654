// SPDX-License-Identifier: Apache-2.0
// The material of a layer that grew on rock, such as flowstone.
#pragma once

#include <vug/field/field.h>
#include <vug/field/kind.h>
#include <vug/field/rock_material_kind.h>

#include <string>

namespace vug::field {

/// A solid of one material; the solid itself without a material.
Field of_material(const Field& solid, const RockMaterialPtr& material);

/// The rock with a layer on it: the layer is of the material, the rock inside keeps its own. The
/// layer counts from half a millimetre on. Without a material, `with_layer`. Error(bad_input) if
/// the rock has no material.
Field grown_on(const Field& rock, const Field& with_layer, const RockMaterialPtr& material);

/// Describes why a rock cannot carry what has grown of this material; empty if it can.
std::string growth_fault(const Field& rock, const RockMaterialPtr& material);

/// The parameter `material` of kinds that grow on rock.
template <class P>
Schema<P>& describe_growth_material(Schema<P>& s) {
  return s.param("material", &P::material,
                 {.doc = "the material of all that has grown, e.g. \"calcite\"; by default that of "
                         "the rock"});
}

}  // namespace vug::field
