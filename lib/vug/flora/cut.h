// SPDX-License-Identifier: Apache-2.0
// Sections of plants between two cuts across their culms.
#pragma once

#include <vug/lsystem/drawing.h>

namespace vug::flora {

struct CutOptions {
  double from = -kInfinity;  ///< Metres along stems of order 0.
  double to = kInfinity;
  int orders = 1000;  ///< Keeps stems of a lower order only.
};

/// The axes of the section; positions along them are unchanged. A branch is kept if its parent is
/// kept where the branch leaves it. Polygons and instances are dropped.
lsystem::Drawing cut(const lsystem::Drawing& drawing, const CutOptions& options);

}  // namespace vug::flora
