// SPDX-License-Identifier: Apache-2.0
// All speleothems of a rock: from its drips to their solids.
#pragma once

#include <vug/drips/build_graph.h>
#include <vug/drips/form_fields.h>

namespace vug::drips {

/// Bounds of the speleothems of all drips that rock with these bounds can have.
Box3d dripstone_bounds(const Box3d& rock, const GraphOptions& graph, const FormOptions& forms);

}  // namespace vug::drips
