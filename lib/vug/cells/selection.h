// How many of the cells a rule chooses.
#pragma once

#include <vug/base/schema.h>
#include <vug/cells/pass.h>

namespace vug::cells {

/// A share of the cells, or so many that they are so far apart, which stays the same when the
/// spacing changes.
struct CellSelection {
  double share = 1;
  double apart = 0;  ///< Metres from one to the next, about; 0: `share` says.

  /// Of being chosen, for a cell that stands for so many square metres.
  double at(const Network& network, uint32_t cell) const {
    return apart > 0 ? static_cast<double>(network.area[cell]) / (apart * apart) : share;
  }
};

/// Its two parameters, of a rule's struct that is derived from it.
template <class P>
void describe_selection(Schema<P>& s) {
  s.param(
       "share", &P::share,
       {.doc = "of the cells, chosen by chance", .dimension = Dimension::ratio, .min = 0, .max = 1})
      .param("apart", &P::apart,
             {.doc = "instead of a share: one for each square with this side",
              .dimension = Dimension::length,
              .min = 0});
}

}  // namespace vug::cells
