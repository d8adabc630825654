// SPDX-License-Identifier: Apache-2.0
// Edges, corners and faces that broke off from blocks at rest.
#pragma once

#include <vug/base/rng.h>
#include <vug/passages/breakdown/oriented_box.h>

#include <vector>

namespace vug::passages {

/// Points at which each block touches another block or the ground at the height `floor`: corners on
/// a face, and crossings of edges.
std::vector<std::vector<Vec3d>> contact_points(const std::vector<OrientedBox>& blocks,
                                               double floor);

/// The part of a block that remains when pieces break off: fractures along edges and across
/// corners, and faces that are not parallel. `amount` (0 to 1) is the depth of the deepest cuts, by
/// a third of the block's smaller sides. No cut removes one of the points at which the block
/// touches others, so that it still rests there.
Polytope broken_block(const OrientedBox& block, const std::vector<Vec3d>& contacts, double amount,
                      RandomStream random);

}  // namespace vug::passages
