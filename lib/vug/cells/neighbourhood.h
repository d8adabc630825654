// What a rule sees of a cell's neighbours: those that distribute. The kinds below do the same;
// which one a rule meets depends on how much has to be looked at.
#pragma once

#include <vug/cells/attributes.h>
#include <vug/cells/links.h>

namespace vug::cells {

/// Links ahead of the cell at work that are called into the cache. They are read once and in order,
/// but processors fetch too little ahead between the scattered reads of neighbours: without this
/// life takes 1.7 times as long.
inline constexpr size_t kAhead = 1024;

/// Says that a sum of whole numbers is needed after each neighbour. Otherwise the compiler reads
/// eight at once by one instruction, which takes longer than eight.
inline void one_by_one(uint32_t& sum) { asm("" : "+r"(sum)); }

/// Some cells may be silent.
struct MixedNeighbourhood {
  const uint32_t* begin;
  const uint32_t* to;
  const CellState* state;

  /// Calls f(neighbour) by rising index; returns how many there were.
  template <class F>
  uint32_t each(uint32_t cell, const F& f) const {
    uint32_t count = 0;
    for (uint32_t k = begin[cell]; k < begin[cell + 1]; ++k)
      if (distributes(state[to[k]])) f(to[k]), ++count;
    return count;
  }
};

/// Every cell is heard.
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

/// And each cell of the block has the same number of links.
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
