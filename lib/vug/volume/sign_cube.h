// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the sides of the samples in a small cube of the lattice, and the topology of
// the mesh that OpenVDB makes there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::volume {

/// Offset of a sample from the centre of the cube.
using Offset = std::array<int, 3>;

class SignCube {
 public:
  static constexpr int kReach = 5;  ///< The largest number of samples on each side of the centre.

  /// Asks `inside(offset)` for the side of each sample up to `reach` from the centre.
  template <class Inside>
  SignCube(int reach, const Inside& inside) {
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z) inside_[index({x, y, z})] = inside(Offset{x, y, z});
  }

  bool inside(const Offset& at) const { return inside_[index(at)]; }
  void flip(const Offset& at) { inside_[index(at)] = !inside_[index(at)]; }

  static size_t index(const Offset& at) {
    return static_cast<size_t>(((at[0] + kReach) * kWidth + at[1] + kReach) * kWidth + at[2] +
                               kReach);
  }
  static constexpr int kWidth = 2 * kReach + 1;
  static constexpr size_t kSize = size_t{kWidth} * kWidth * kWidth;

 private:
  std::array<bool, kSize> inside_{};
};

/// The part of the Euler characteristic of OpenVDB's mesh that samples at most `reach` from the
/// centre can change: the number of its vertices minus the number of its quads. A closed mesh has
/// twice as many edges as quads, so that V - E + F = V - F. The cube reaches 3 further.
int euler_characteristic(const SignCube& cube, int reach);

/// By how much it grows if these samples, at most `reach` from the centre, change sides.
int euler_change(const SignCube& cube, const std::vector<Offset>& samples, int reach);

/// The samples on the centre's side across a gap of less than `steps` samples, 2 or 3: all samples
/// next to the straight line between are on the other side, and the box of the two does not connect
/// them.
std::vector<Offset> opposite_samples(const SignCube& cube, int steps);

}  // namespace vug::volume
