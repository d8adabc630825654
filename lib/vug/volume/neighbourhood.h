// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the samples of a block of 8^3 at which the topology of a surface may change.
#pragma once

#include <vug/volume/sign_cube.h>

#include <array>
#include <cstdint>

namespace vug::volume {

/// The sides of a block of 8^3 samples and its neighbours, one bit per sample along z.
class SignRows {
 public:
  template <class Inside>
  explicit SignRows(const Inside& inside) {
    for (int x = -1; x <= 8; ++x)
      for (int y = -1; y <= 8; ++y) {
        unsigned bits = 0;
        for (int z = -1; z <= 8; ++z)
          bits |= static_cast<unsigned>(inside(Offset{x, y, z})) << (z + 1);
        rows_[index(x, y)] = static_cast<uint16_t>(bits);
      }
  }

  /// One bit per sample with a neighbour on the other side along an axis, for z = 0 .. 7.
  unsigned surface(int x, int y) const;
  /// One bit per sample without a neighbour on its own side in the negative directions: each closed
  /// set of samples has one.
  unsigned low_corners(int x, int y) const;
  /// The 27 samples around one, with x * 9 + y * 3 + z as the index of their bits.
  uint32_t around(int x, int y, int z) const;

 private:
  static size_t index(int x, int y) { return static_cast<size_t>((x + 1) * 10 + y + 1); }
  unsigned row(int x, int y) const { return rows_[index(x, y)]; }

  std::array<uint16_t, 100> rows_;
};

/// Whether the 26 neighbours of a sample are connected on either side by steps along the axes, so
/// that it is a simple point for all rules about diagonal neighbours.
bool is_simple(uint32_t around);

/// Whether no cube of eight samples around a sample is on its side.
bool is_thin(uint32_t around);

/// Calls visit(offset) for the samples next to the surface that are not simple points, are thin, or
/// are the lowest corner of a set. `inside` is asked for offsets from -1 to 8.
template <class Inside, class Visit>
void for_each_special_point(const Inside& inside, const Visit& visit) {
  const SignRows rows(inside);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      const unsigned surface = rows.surface(x, y), corners = rows.low_corners(x, y);
      for (int z = 0; z < 8; ++z) {
        if (!(surface >> z & 1U)) continue;
        const uint32_t around = rows.around(x, y, z);
        if ((corners >> z & 1U) || is_thin(around) || !is_simple(around)) visit(Offset{x, y, z});
      }
    }
}

}  // namespace vug::volume
