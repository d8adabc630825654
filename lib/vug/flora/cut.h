// A piece of a plant: what lies between two cuts across its culms.
#pragma once

#include <vug/lsystem/drawing.h>

namespace vug::flora {

struct CutOptions {
  double from = -kInfinity;  ///< Metres along stems of order 0.
  double to = kInfinity;
  int orders = 1000;  ///< Only stems of a lower order.
};

/// The axes of the piece, with their lengths along as they were; branches stay that leave a stem
/// that stays, where it stays. Without polygons and instances.
lsystem::Drawing cut(const lsystem::Drawing& drawing, const CutOptions& options);

}  // namespace vug::flora
