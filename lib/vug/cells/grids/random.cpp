// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/kind.h>

#include <cmath>

namespace vug::cells {
namespace {

struct Random {
  static void describe(Schema<Random>& s) {
    s.doc(
         "Random points with a minimum distance, about one per squared spacing, followed by "
         "relaxation: five to seven neighbours on any surface.")
        .cite("gobron2006");
  }
  Grid grid() const {
    Grid grid;
    grid.reach = std::sqrt(3.0) - 0.05;
    grid.full = 6;
    grid.thin = grid.gap = 0.75;
    grid.relax = 30;
    return grid;
  }
};

}  // namespace
}  // namespace vug::cells

VUG_GRID_KIND(random) { return grid_kind<Random>("random"); }
