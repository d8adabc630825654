// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/kind.h>

#include <cmath>

namespace vug::cells {
namespace {

struct Triangle {
  static void describe(Schema<Triangle>& s) {
    s.doc("Vertices of equilateral triangles: six neighbours, all one spacing away.")
        .cite("gobron2006");
  }
  Grid grid() const {
    const double root3 = std::sqrt(3.0);
    Grid grid;
    grid.motif = {{0, 0}};
    grid.along = {0.5, root3 / 2};
    grid.reach = root3 - 0.05;
    grid.full = 6;
    grid.gap = 0.8;
    return grid;
  }
};

}  // namespace
}  // namespace vug::cells

VUG_GRID_KIND(triangle) { return grid_kind<Triangle>("triangle"); }
