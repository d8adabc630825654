// SPDX-License-Identifier: Apache-2.0
// Internal to karst: the course of a passage between two samples.
#pragma once

#include <vug/karst/options.h>
#include <vug/karst/rock.h>
#include <vug/karst/segment_grid.h>
#include <vug/network/network.h>

namespace vug::karst {

inline constexpr int kShapeAttempts = 8;

/// The points of a passage from `from` to `to`, both included, in the direction of the water. In
/// plan it wanders (random displacement of midpoints) or follows joints in steps. Vadose passages
/// descend with the slope of the options and drop in pitches, phreatic ones loop below their ends.
/// Each attempt from 0 on has smaller displacements in plan, every second one ends with a pitch,
/// and the last one is straight.
std::vector<Vec3d> shape_passage(const network::Leg& leg, const SegmentPiece& ends,
                                 const Rock& rock, const ShapeOptions& options, int attempt,
                                 RandomKey key);

}  // namespace vug::karst
