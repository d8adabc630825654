// SPDX-License-Identifier: Apache-2.0
// The neighbours of a cell that are visible to a rule, that is, those that distribute. The types
// below have the same interface; the required checks determine which one a rule receives.
#pragma once

#include <vug/cells/attributes.h>
#include <vug/cells/links.h>

namespace vug::cells {

/// Prefetch distance in links. Links are read once and in order, but hardware prefetching is too
/// short between the scattered reads of neighbours: without this, life takes 1.7 times as long.
inline constexpr size_t kAhead = 1024;

/// Forces the compiler to update an integer sum after each neighbour. Otherwise it gathers eight
/// values with one instruction, which is slower than eight loads.
inline void one_by_one(uint32_t& sum) { asm("" : "+r"(sum)); }

/// Some cells may not distribute.
struct MixedNeighbourhood {
  const uint32_t* begin;
  const uint32_t* to;
  const CellState* state;

  /// Calls f(neighbour) in ascending order and returns the number of calls.
  template <class F>
  uint32_t each(uint32_t cell, const F& f) const {
    uint32_t count = 0;
    for (uint32_t k = begin[cell]; k < begin[cell + 1]; ++k)
      if (distributes(state[to[k]])) f(to[k]), ++count;
    return count;
  }
};

/// All cells distribute.
struct UniformNeighbourhood {
  const uint32_t* begin;
  const uint32_t* to;

  template <class F>
  uint32_t each(uint32_t cell, const F& f) const {
    const uint32_t first = begin[cell], last = begin[cell + 1];
    __builtin_prefetch(to + first + kAhead);
    for (uint32_t k = first; k < last; ++k) f(to[k]);
    return last - first;
  }
};

/// All cells distribute, and each cell of the block has the same number of links.
template <uint32_t kLinks>
struct RegularNeighbourhood {
  const uint32_t* to;  ///< Links of the cell `first`.
  uint32_t first;

  template <class F>
  uint32_t each(uint32_t cell, const F& f) const {
    const uint32_t* row = to + size_t{cell - first} * kLinks;
    __builtin_prefetch(row + kAhead);
#pragma GCC unroll 8
    for (uint32_t k = 0; k < kLinks; ++k) f(row[k]);
    return kLinks;
  }
};

}  // namespace vug::cells
