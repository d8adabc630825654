// SPDX-License-Identifier: Apache-2.0
// Inside flora/ only: creates the cross-sections of a tube from the stations of an axis.
#pragma once

#include <vug/flora/tube.h>

namespace vug::flora {

/// Cross-sections from `begin` metres on, with rotation-minimising frames; smoothed where the axis
/// is smooth. Fewer than two if nothing is left.
std::vector<Ring> make_rings(const lsystem::Axis& axis, double begin, const SweepOptions& options);

}  // namespace vug::flora
