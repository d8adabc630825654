// SPDX-License-Identifier: Apache-2.0
// Attributes of cells on a surface that has grown, from the cells that it had before.
#pragma once

#include <vug/base/progress.h>
#include <vug/cells/simulation.h>

namespace vug::cells {

/// Gives the cells of `to` the attributes of those of `from` where they are now, displaced by P and
/// height, with the weights of transfer_to_mesh; whole numbers are rounded. The displacement itself
/// (P, N and height) starts anew, and so do outlets. Cells among removed ones are removed.
void inherit_attributes(const Simulation& from, Simulation& to,
                        Progress& progress = Progress::none());

}  // namespace vug::cells
