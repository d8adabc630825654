// SPDX-License-Identifier: Apache-2.0
// Samples along joints of finite length, joined so that passages can follow
// them.
#pragma once

#include <vug/karst/rock.h>
#include <vug/karst/segment_grid.h>

#include <array>
#include <functional>
#include <vector>

namespace vug::karst {

/// Places samples on each bed (without beds in the middle of the bounds): first where joints cross,
/// then at the ends of joints and between, at most `step` metres apart. `add` returns the index of
/// an accepted sample, or -1. Returns the pairs of consecutive samples of a joint, the smaller
/// index first, sorted.
std::vector<std::array<int, 2>> sample_joints(const std::vector<SegmentPiece>& traces,
                                              const Geology& geology, double step,
                                              const std::function<int(const Vec3d&)>& add);

}  // namespace vug::karst
