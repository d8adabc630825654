// SPDX-License-Identifier: Apache-2.0
// All materials that the nodes of an expression assign.
#pragma once

#include <vug/field/field.h>
#include <vug/field/material_mix.h>

#include <vector>

namespace vug::field {

/// The materials that the nodes of the field assign, node by node; a name may occur several times.
/// Fields that have not been computed do not contribute. See materials_of, which has each name
/// once.
std::vector<RockMaterialPtr> assigned_materials(const Field& field);

}  // namespace vug::field
