// SPDX-License-Identifier: Apache-2.0
// The distances to the walls along a passage, where some or all of them were not measured.
#pragma once

#include <vug/passages/curves/chains.h>

#include <vector>

namespace vug::passages {

/// Distances from the survey line to the walls in metres, seen along the chain.
struct Walls {
  double left = 0, right = 0, up = 0, down = 0;
  bool measured = false;  ///< Whether any of them was measured at this station.

  double width() const { return left + right; }
  double height() const { return up + down; }
};

/// The size of passages that were not measured, in metres.
struct DefaultSize {
  double width = 1.3;
  double height = 1.7;
  double least = 0.3;  ///< Smaller widths and heights are raised to this one.
};

/// The walls at each station of a chain. A missing distance is interpolated along the chain between
/// the stations on both sides that have it, is that of the nearest one beyond them, and half of the
/// default size if none has it. The section of a station where another passage continues is that of
/// the other passage, and is used only if no station of the chain itself was measured.
std::vector<Walls> walls_along(const network::Network& network, const Chain& chain,
                               const DefaultSize& size);

}  // namespace vug::passages
