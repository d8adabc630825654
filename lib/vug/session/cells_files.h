// Cells to files: points, grids beside the level set, tables.
#pragma once

#include <vug/cells/as_points.h>
#include <vug/session/build.h>
#include <vug/session/cells_plan.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace vug::session {

/// The cells that a shot declares, in its order; also those that others stand on.
std::vector<CellsPtr> declared_cells(const Shot& shot);

/// The cells as a grid of points under the plan's name, with the step that they are at
/// ("vug:step") and what they are kept for ("vug:keep").
volume::Grid cell_points(const CellsPlan& plan, const Skin& skin,
                         cells::Keep keep = cells::Keep::shown);

/// What the cells carry in the bands of the level sets that they stand on, smoothed as at vertices
/// of a mesh: a vec3s grid NAME_Cd and float grids NAME_ATTRIBUTE for each, with the name of the
/// level set behind NAME where these are several. Error(too_large).
std::vector<volume::Grid> cell_grids(Builder& builder, const CellsPtr& plan);

/// A line for each cell with its number, place, normal, what it carries and its state, and before
/// them a line of their names: x, y and z, so that a scene can place things there.
void write_table(const std::filesystem::path& file, const Skin& skin);

/// Of the file that cells go on from the points of their name, or the first that there are; null
/// where they go on from none. Their values stay on the disk until they are asked for. Error at the
/// plan's name where the file cannot be read or holds no points.
std::optional<volume::Grid> points_from(const CellsPlan& plan);

/// Puts back what points carry that cell_points has made of equal cells. Error(bad_input).
void read_cells(const volume::Grid& points, cells::Simulation& simulation);

}  // namespace vug::session
