// Skins of cells as Python holds them.
#pragma once

#include "binding.h"

#include <vug/building/cell_layer.h>
#include <vug/volume/io.h>

namespace vug::python {

/// Immutable; its arrays share what it points to.
struct Cells {
  shot::CellsPtr plan;
  building::CellLayerPtr layer;
  volume::WriteOptions write;
};

}  // namespace vug::python
