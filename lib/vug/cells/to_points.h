// SPDX-License-Identifier: Apache-2.0
// Conversion of the attributes and states of cells to points, and back.
#pragma once

#include <vug/cells/simulation.h>
#include <vug/volume/points.h>

namespace vug::cells {

/// The purpose of a points file.
enum class PointFormat {
  interchange,  ///< For other programs: 16 bits where sufficient, and the attributes that point
                ///< renderers expect.
  exact,  ///< For continuation: every bit of the cells' attributes, without data that the network
          ///< provides.
};

/// Converts cells to points in their order, which `id` records. Interchange: current P and N,
/// pscale (radius in metres of a disc with the cell's area), object (if there are several), and
/// every attribute under its name, Cd as 16 bits. Exact: P_full and N of moved cells, and every
/// attribute. Groups represent the states by name. Throws Error(bad_input) for a cell attribute
/// named id.
volume::Points to_points(const Simulation& simulation, PointFormat keep = PointFormat::interchange);

/// Voxel size of their grid: see volume::voxel_for_points.
double voxel_of_points(const Network& network);

/// Restores cells from points that to_points created in the same format for an equal network, as
/// if the simulation had performed `step` steps. Exact points allow continuation to the same bytes
/// as without interruption, interchange points to approximately the same. With the latter, cells
/// have moved if a point is farther than `apart` metres from its cell or its normal differs by a
/// tenth of a degree; attributes that a rule named pscale or object are not restored. Throws
/// Error(bad_input) if the number of points differs, or ids from 0 or groups for states are
/// missing.
void restore(Simulation& simulation, const volume::Points& points, int step, PointFormat keep,
             double apart = 0);

}  // namespace vug::cells
