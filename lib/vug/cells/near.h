// What a rule sees of a cell's neighbours: those that distribute. The kinds below do the same;
// which one a rule meets depends on how much has to be looked at.
#pragma once

#include <vug/cells/attributes.h>
#include <vug/cells/links.h>

namespace vug::cells {

/// Some cells may be silent.
struct NearMixed {
  const uint32_t* begin;
  const uint32_t* to;
  const State* state;

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
struct NearAll {
  const uint32_t* begin;
  const uint32_t* to;

  template <class F>
  uint32_t each(uint32_t cell, const F& f) const {
    const uint32_t first = begin[cell], last = begin[cell + 1];
    for (uint32_t k = first; k < last; ++k) f(to[k]);
    return last - first;
  }
};

/// And each cell of the block has the same number of links.
template <uint32_t kLinks>
struct NearFull {
  const uint32_t* to;  ///< Links of the cell `first`.
  uint32_t first;

  template <class F>
  uint32_t each(uint32_t cell, const F& f) const {
    const uint32_t* row = to + size_t{cell - first} * kLinks;
    for (uint32_t k = 0; k < kLinks; ++k) f(row[k]);
    return kLinks;
  }
};

}  // namespace vug::cells
