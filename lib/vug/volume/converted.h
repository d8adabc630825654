// Grids in the coordinates of other programs.
#pragma once

#include <vug/base/transform.h>
#include <vug/volume/grid.h>

namespace vug::volume {

/// The same voxels where `to_target`, which keeps angles, takes them: only the grid's transform
/// changes, and the distances of a level set, which grow as lengths do.
Grid converted(const Grid& grid, const Transform& to_target);

}  // namespace vug::volume
