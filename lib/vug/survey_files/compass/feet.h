// SPDX-License-Identifier: Apache-2.0
// The unit of lengths in all files of Compass.
#pragma once

namespace vug::survey::compass {

constexpr double kFoot = 0.3048;  ///< Metres.
/// Distances to walls above are missing, as negative ones. Feet.
constexpr double kMissingWall = 900;

}  // namespace vug::survey::compass
