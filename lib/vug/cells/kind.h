// SPDX-License-Identifier: Apache-2.0
// Definitions for the source file of a grid in grids/.
#pragma once

#include <vug/base/kind.h>
#include <vug/cells/grid.h>

/// Opens the one definition exported by the file of a grid; see VUG_EXPORT_KIND.
#define VUG_GRID_KIND(name) VUG_EXPORT_KIND(vug::cells, GridKind, name##_grid)

namespace vug::cells {

using GridKind = Kind<Grid>;

const Kinds<Grid>& grids();

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and `Grid grid() const`.
template <class P>
GridKind grid_kind(std::string name) {
  return make_kind<Grid, P>(name, "grid", [name](const P& params) {
    Grid grid = params.grid();
    grid.name = name;
    return grid;
  });
}

}  // namespace vug::cells

namespace vug {

template <>
struct ValueTraits<cells::Grid> : ObjectTraits<cells::Grid> {
  static constexpr const char* kWord = "grid";
};

}  // namespace vug
