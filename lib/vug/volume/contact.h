// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: samples whose distance is zero to within rounding count as inside, so that
// solids that touch in a face on the lattice are one solid without a crack between them. Their
// values become negative and keep their magnitude, except that 0 becomes the smallest number.
#pragma once

#include <limits>

namespace vug::volume {

/// The largest distance in metres that single precision cannot distinguish from zero for points
/// whose coordinates have at most the given magnitude.
inline float contact_distance(double largest_coordinate) {
  return static_cast<float>(2 * std::numeric_limits<float>::epsilon() * largest_coordinate);
}

/// Samples may be inside by up to this number of voxels because of rounding: coordinates in a brick
/// are at most some hundred voxels.
constexpr double kContactInVoxels = 1e-4;

/// The magnitude of values that were 0.
constexpr float kLeastDistance = std::numeric_limits<float>::min();

}  // namespace vug::volume
