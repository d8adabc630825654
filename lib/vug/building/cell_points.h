// Cells as grids of points, and back again.
#pragma once

#include <vug/building/cell_layer.h>
#include <vug/cells/to_points.h>
#include <vug/shot/cells_plan.h>
#include <vug/volume/grid.h>

#include <optional>

namespace vug::building {

/// The cells as a grid of points under the plan's name, with the step that they are at
/// ("vug:step") and what they are kept for ("vug:keep").
volume::Grid cell_points(const shot::CellsPlan& plan, const CellLayer& layer,
                         cells::PointFormat keep = cells::PointFormat::interchange);

/// Of the file that cells go on from the points of their name, or the first that there are; null
/// where they go on from none. Their values stay on the disk until they are asked for. Error at the
/// plan's name where the file cannot be read or holds no points.
std::optional<volume::Grid> initial_points(const shot::CellsPlan& plan);

/// Puts back what points carry that cell_points has made of equal cells. Error(bad_input).
void restore_cells(const volume::Grid& points, cells::Simulation& simulation);

}  // namespace vug::building
