// The ways out of an L-system's drawing into a scene: stems as a field, places of its things.
#pragma once

#include <vug/field/kind.h>

namespace vug::loading {

/// Fields that are made of drawings; they join the family of field kinds. Made from the list in
/// CMakeLists.txt.
const Kinds<field::Field>& plant_kinds();

using PlantKind = field::FieldKind;

/// Opens the one function that the file of such a kind exports.
#define VUG_PLANT_KIND(name) VUG_EXPORT_KIND(vug::loading, PlantKind, name##_plant)

}  // namespace vug::loading
