// SPDX-License-Identifier: Apache-2.0
// Grids, as seen from Python.
#pragma once

#include "binding.h"

#include <vug/volume/io.h>
#include <vug/volume/level_set.h>

namespace vug::python {

/// A grid with the metadata that its files contain about their origin.
struct Grid {
  volume::Grid grid;
  volume::WriteOptions write;
};

struct LevelSet : Grid {
  volume::LevelSet level_set() const { return volume::LevelSet(grid); }
};

}  // namespace vug::python
