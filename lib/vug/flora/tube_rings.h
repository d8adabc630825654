// Inside of flora/ only: the cross-sections of a tube from the stations of an axis.
#pragma once

#include <vug/flora/tube.h>

namespace vug::flora {

/// From `begin` metres along on; smooth where the axis is, with frames that do not twist. Fewer
/// than two where nothing is left.
std::vector<Ring> make_rings(const lsystem::Axis& axis, double begin, const SweepOptions& options);

}  // namespace vug::flora
