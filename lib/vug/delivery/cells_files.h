// Cells to files: points, grids beside the level set, tables.
#pragma once

#include <vug/building/builder.h>
#include <vug/cells/to_points.h>
#include <vug/shot/cells_plan.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace vug::delivery {

/// What the cells carry in the bands of the level sets that they stand on, smoothed as at vertices
/// of a mesh: a vec3s grid NAME_Cd and float grids NAME_ATTRIBUTE for each, with the name of the
/// level set behind NAME where these are several. Error(too_large).
std::vector<volume::Grid> cell_grids(building::Builder& builder, const shot::CellsPtr& plan);

/// A line for each cell with its number, place, normal, what it carries and its state, and before
/// them a line of their names: x, y and z, so that a scene can place things there.
void write_table(const std::filesystem::path& file, const building::CellLayer& layer);

}  // namespace vug::delivery
