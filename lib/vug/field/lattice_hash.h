// SPDX-License-Identifier: Apache-2.0
// Random numbers of the cells of an integer lattice, over doubles and packs.
#pragma once

#include <vug/field/lattice_lanes.h>

namespace vug::field {

/// Odd multipliers, one per axis.
inline constexpr uint32_t kLatticeAxis[3] = {0x8da6b343, 0xd8163841, 0xcb1ab31f};

/// Two rounds of multiply and shift: murmur3's finaliser.
template <class S>
typename Lanes<S>::Int finish_hash(typename Lanes<S>::Int h) {
  using L = Lanes<S>;
  h = L::multiply(L::bit_xor(h, L::shift_right(h, 16)), 0x85ebca6b);
  h = L::multiply(L::bit_xor(h, L::shift_right(h, 13)), 0xc2b2ae35);
  return L::bit_xor(h, L::shift_right(h, 16));
}

/// The random numbers of a cell, in sequence; the coordinates of the cell are whole numbers with
/// |coordinate| < 1e9.
template <class S>
class CellRandom {
 public:
  CellRandom(const S& x, const S& y, const S& z, uint32_t seed) {
    using L = Lanes<S>;
    hash_ = L::bit_xor(L::multiply(L::to_int(x), kLatticeAxis[0]), seed, 0);
    hash_ = L::bit_xor(hash_, L::multiply(L::to_int(y), kLatticeAxis[1]));
    hash_ = L::bit_xor(hash_, L::multiply(L::to_int(z), kLatticeAxis[2]));
  }
  /// Uniform in [0, 1).
  S next() {
    hash_ = finish_hash<S>(Lanes<S>::add(hash_, 0x9e3779b9));
    return Lanes<S>::to_unit(hash_);
  }
  /// A position in a cell of side 1: its middle, moved by at most `jitter`.
  S position(double jitter) { return (next() - S(0.5)) * S(2 * jitter) + S(0.5); }

 private:
  typename Lanes<S>::Int hash_;
};

}  // namespace vug::field
