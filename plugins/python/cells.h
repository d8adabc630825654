// SPDX-License-Identifier: Apache-2.0
// Cell layers, as seen from Python.
#pragma once

#include "binding.h"

#include <vug/building/cell_layer.h>
#include <vug/volume/io.h>

namespace vug::python {

/// An immutable layer of cells. Its arrays share the memory that it points to.
struct Cells {
  shot::CellsPtr plan;
  building::CellLayerPtr layer;
  volume::WriteOptions write;
};

}  // namespace vug::python
