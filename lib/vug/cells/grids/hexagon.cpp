// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/kind.h>

#include <cmath>

namespace vug::cells {
namespace {

struct Hexagon {
  static void describe(Schema<Hexagon>& s) {
    s.doc("Vertices of a honeycomb: three neighbours, all one spacing away.").cite("gobron2006");
  }
  Grid grid() const {
    const double root3 = std::sqrt(3.0);
    Grid grid;
    grid.motif = {{0, 0}, {0, 1}};
    grid.across = {root3, 0};
    grid.along = {root3 / 2, 1.5};
    grid.reach = root3 - 0.05;
    grid.full = 3;
    grid.gap = 1.1;  // The centre of a honeycomb stays empty.
    return grid;
  }
};

}  // namespace
}  // namespace vug::cells

VUG_GRID_KIND(hexagon) { return grid_kind<Hexagon>("hexagon"); }
