// SPDX-License-Identifier: Apache-2.0
// Internal to karst: the course of a passage between two samples.
#pragma once

#include <vug/karst/options.h>
#include <vug/karst/rock.h>
#include <vug/network/network.h>

namespace vug::karst {

/// The points of a passage from `from` to `to`, both included, in the direction of the water. In
/// plan it wanders (random displacement of midpoints) or follows joints in steps. Vadose passages
/// descend with the slope of the options and drop in pitches, phreatic ones loop below their ends.
std::vector<Vec3d> shape_passage(const Vec3d& from, const Vec3d& to, network::Stage stage,
                                 const Rock& rock, const ShapeOptions& options, RandomKey key);

}  // namespace vug::karst
