// SPDX-License-Identifier: Apache-2.0
// Kinds of fields that are made from the drawing of an L-system, such as stems.
#pragma once

#include <vug/field/kind.h>

namespace vug::loading {

/// The kinds listed in CMakeLists.txt; they belong to the registry of fields.
const Kinds<field::Field>& plant_kinds();

using PlantKind = field::FieldKind;

/// Begins the definition of the function that the source of such a kind exports.
#define VUG_PLANT_KIND(name) VUG_EXPORT_KIND(vug::loading, PlantKind, name##_plant)

}  // namespace vug::loading
