// SPDX-License-Identifier: Apache-2.0
// Runs of cells on a surface that grows so far that it needs new cells.
#pragma once

#include <vug/shot/cells_plan.h>

namespace vug::shot {

/// Divides the run into `rescatter` + 1 parts of about equal length. After each part but the last,
/// the displaced mesh becomes a level set with the voxels of the one below, which has no folds, and
/// the next part runs on new cells on its mesh. Returns the plan of the last part. The plan must
/// lie on one mesh of a level set.
CellsPtr divide_run(CellsPlan plan);

}  // namespace vug::shot
