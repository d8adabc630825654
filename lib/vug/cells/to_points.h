// Cells as points with attributes, and points as cells that go on.
#pragma once

#include <vug/cells/simulation.h>
#include <vug/volume/points.h>

namespace vug::cells {

/// What a points file is for.
enum class PointFormat {
  interchange,  ///< Other programs: 16 bits where they do, and what renderers of points ask for.
  exact,  ///< Going on: every bit of what the cells carry, and nothing that the network tells.
};

/// Cells in their order, which `id` keeps. Shown: P and N where the cells are now, pscale (the
/// radius, metres, of a disc of the cell's area), object (where there are several), and every
/// attribute under its name, Cd as 16 bits. Exact: P_full and N where cells have moved, and every
/// attribute. Groups are the states, each by its name. Error(bad_input) for an attribute of the
/// cells that is called id.
volume::Points to_points(const Simulation& simulation, PointFormat keep = PointFormat::interchange);

/// An edge for the voxels of their grid: see volume::voxel_for_points.
double voxel_of_points(const Network& network);

/// Gives the cells what points carry that to_points has made, in that way of keeping, of cells of
/// an equal network, as if the simulation had done `step` steps: exact points let it go on to the
/// same bytes as if it had never stopped, shown ones to about the same. Of these cells have moved
/// where a point lies farther than `apart` metres from one, or faces a tenth of a degree elsewhere;
/// and what a rule had called pscale or object is not put back. Error(bad_input) where points are
/// of another number, or lack ids from 0 or groups for states.
void restore(Simulation& simulation, const volume::Points& points, int step, PointFormat keep,
             double apart = 0);

}  // namespace vug::cells
