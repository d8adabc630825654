// Where to put the nodes of a tree so that it can be read.
#pragma once

#include <vug/grammar/tree.h>

namespace vug::grammar {

/// The across-coordinate of every node (the other one is its depth), in units of the distance
/// between neighbours; 0 is the smallest. A parent stands in the middle of its outer children,
/// equal subtrees look equal, and subtrees are as near as their contours let them. The
/// aesthetics and the contours are those of Reingold and Tilford (reingold1981), with contours kept
/// deepest level first so that joining two costs the depth of the shallower one.
std::vector<double> tidy_layout(const Tree& tree);

}  // namespace vug::grammar
