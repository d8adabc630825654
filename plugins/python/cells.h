// Skins of cells as Python holds them.
#pragma once

#include "binding.h"

#include <vug/session/skin.h>
#include <vug/volume/io.h>

namespace vug::python {

/// Immutable; its arrays share what it points to.
struct Cells {
  session::CellsPtr plan;
  session::SkinPtr skin;
  volume::WriteOptions write;
};

}  // namespace vug::python
