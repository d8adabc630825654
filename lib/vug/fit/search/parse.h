// SPDX-License-Identifier: Apache-2.0
// Top-down search for trees: each area is tried with every production, and recursively its parts,
// as far as the evidence promises a gain.
#pragma once

#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/move.h>

namespace vug::fit {

struct ParseOptions {
  int depth = 3;    ///< Maximum nesting of splits.
  int breadth = 3;  ///< Number of best splits of an area that are expanded further.
  /// Minimum share of an area's potential gain that remains when its instances are folded on top of
  /// each other.
  double min_potential = 0.8;
};

/// The tree of least energy found below node i, which has not been rewritten. `gains` describe the
/// appearance of windows.
TreeState parse(const MoveContext& context, const Evidence& evidence, const Gains& gains,
                TreeState state, int i, const ParseOptions& options = {});

}  // namespace vug::fit
