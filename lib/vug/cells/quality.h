// How even a network is.
#pragma once

#include <vug/cells/network.h>

#include <array>

namespace vug::cells {

struct Quality {
  double nearest = 0;               ///< Mean distance to the nearest linked cell, metres.
  double variation = 0;             ///< Standard deviation of that distance as a share of the mean.
  std::array<size_t, 9> degrees{};  ///< How many cells have so many links.

  /// Share of the cells that have `low` to `high` links.
  double share(size_t low, size_t high) const;
};

Quality quality(const Network& network);

}  // namespace vug::cells
