// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/kind.h>

#include <cmath>

namespace vug::cells {
namespace {

struct Square {
  int neighbors = 4;

  static void describe(Schema<Square>& s) {
    s.doc("Vertices of a square grid.")
        .cite("gobron2006")
        .param("neighbors", &Square::neighbors,
               {.doc = "4 for neighbours across the sides, or 8 including the diagonals",
                .min = 4,
                .max = 8});
  }
  std::string fault() const {
    return neighbors == 4 || neighbors == 8 ? "" : "a cell of a square grid has 4 or 8 neighbours";
  }
  Grid grid() const {
    Grid grid;
    grid.motif = {{0, 0}};
    grid.reach = (neighbors == 4 ? std::sqrt(2.0) : 2.0) - 0.05;
    grid.full = static_cast<uint32_t>(neighbors);
    return grid;
  }
};

}  // namespace
}  // namespace vug::cells

VUG_GRID_KIND(square) { return grid_kind<Square>("square"); }
