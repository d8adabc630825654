// SPDX-License-Identifier: Apache-2.0
// Uniformity of a network.
#pragma once

#include <vug/cells/network.h>

#include <array>

namespace vug::cells {

struct Quality {
  double nearest = 0;               ///< Mean distance to the nearest linked cell, metres.
  double variation = 0;             ///< Standard deviation of that distance relative to the mean.
  std::array<size_t, 9> degrees{};  ///< Number of cells by number of links.

  /// The fraction of cells with `low` to `high` links.
  double share(size_t low, size_t high) const;
};

Quality quality(const Network& network);

}  // namespace vug::cells
