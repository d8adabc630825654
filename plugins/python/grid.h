// Grids as Python holds them.
#pragma once

#include "binding.h"

#include <vug/volume/io.h>
#include <vug/volume/level_set.h>

namespace vug::python {

/// With what a file of it tells about where it comes from.
struct Grid {
  volume::Grid grid;
  volume::WriteOptions write;
};

struct LevelSet : Grid {
  volume::LevelSet level_set() const { return volume::LevelSet(grid); }
};

}  // namespace vug::python
