// SPDX-License-Identifier: Apache-2.0
// Transforms grids to the coordinates of another program.
#pragma once

#include <vug/base/transform.h>
#include <vug/volume/grid.h>

namespace vug::volume {

/// Applies `to_target`, a similarity transform, to the grid: the voxels are unchanged, only the
/// grid's transform changes, and the distances of a level set, which scale with lengths.
Grid converted(const Grid& grid, const Transform& to_target);

}  // namespace vug::volume
