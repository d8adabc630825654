// SPDX-License-Identifier: Apache-2.0
// Layout of trees for drawings.
#pragma once

#include <vug/grammar/tree.h>

namespace vug::grammar {

/// The transverse coordinate of every node (the other one is its depth), in units of the distance
/// between neighbours; the smallest is 0. A parent is centred over its outer children, equal
/// subtrees have equal drawings, and subtrees are as close as their contours permit. The aesthetics
/// and the contours are those of Reingold and Tilford (reingold1981); contours are stored deepest
/// level first, so merging two costs the depth of the shallower one.
std::vector<double> tidy_layout(const Tree& tree);

}  // namespace vug::grammar
