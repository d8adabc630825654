// SPDX-License-Identifier: Apache-2.0
// Grids of points with the attributes that a plan of cells requests, and initial states from such
// grids.
#pragma once

#include <vug/building/cell_layer.h>
#include <vug/cells/to_points.h>
#include <vug/shot/cells_plan.h>
#include <vug/volume/grid.h>

#include <optional>

namespace vug::building {

/// The cells as a grid of points with the plan's name, with their step ("vug:step") and the format
/// of their values ("vug:keep") as metadata.
volume::Grid cell_points(const shot::CellsPlan& plan, const CellLayer& layer,
                         cells::PointFormat keep = cells::PointFormat::interchange);

/// The points to continue from: of the plan's file those with its name, else the first points;
/// nothing if the plan has no file. Their values are read on demand. Error, located at the plan's
/// name, if the file cannot be read or contains no points.
std::optional<volume::Grid> initial_points(const shot::CellsPlan& plan);

/// Restores the state that cell_points stored for equal cells. Error(bad_input) for other points.
void restore_cells(const volume::Grid& points, cells::Simulation& simulation);

}  // namespace vug::building
