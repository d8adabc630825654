// SPDX-License-Identifier: Apache-2.0
// Writes cells to files: grids next to the level set, and tables.
#pragma once

#include <vug/building/builder.h>
#include <vug/cells/to_points.h>
#include <vug/shot/cells_plan.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace vug::delivery {

/// The attributes of the cells in the narrow bands of the level sets below them, interpolated as at
/// the vertices of a mesh: a vec3s grid NAME_Cd and float grids NAME_ATTRIBUTE for each level set;
/// for several level sets, NAME is followed by the name of the level set. Error(too_large).
std::vector<volume::Grid> cell_grids(building::Builder& builder, const shot::CellsPtr& plan);

/// Writes a table with a header line and one line per cell: its index, position, normal, attributes
/// and state. The columns x, y and z allow a scene to use it as an instance source.
void write_table(const std::filesystem::path& file, const building::CellLayer& layer);

}  // namespace vug::delivery
