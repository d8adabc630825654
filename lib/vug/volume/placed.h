// Grids in the coordinates of other programs.
#pragma once

#include <vug/base/transform.h>
#include <vug/volume/grid.h>

namespace vug::volume {

/// The same voxels where `way`, which keeps angles, takes them: only the grid's transform changes,
/// and the distances of a level set, which grow as lengths do.
Grid placed(const Grid& grid, const Transform& way);

}  // namespace vug::volume
