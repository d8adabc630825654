// SPDX-License-Identifier: Apache-2.0
// Parameters of rules that affect a random fraction of the cells.
#pragma once

#include <vug/base/schema.h>
#include <vug/cells/pass.h>

namespace vug::cells {

/// A fraction of the cells, or a distance between selected cells, which is independent of the
/// spacing.
struct CellSelection {
  double share = 1;
  double apart = 0;  ///< Approximate distance between selected cells in metres; 0: use `share`.

  /// The probability that a cell is selected, given its area.
  double at(const Network& network, uint32_t cell) const {
    return apart > 0 ? static_cast<double>(network.area[cell]) / (apart * apart) : share;
  }
};

/// Describes the two parameters for a rule's struct derived from CellSelection.
template <class P>
void describe_selection(Schema<P>& s) {
  s.param("share", &P::share,
          {.doc = "fraction of the cells, chosen at random",
           .dimension = Dimension::ratio,
           .min = 0,
           .max = 1})
      .param("apart", &P::apart,
             {.doc = "instead of a share: one cell for each square with this side",
              .dimension = Dimension::length,
              .min = 0});
}

}  // namespace vug::cells
