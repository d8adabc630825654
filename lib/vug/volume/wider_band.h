// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vug/volume/level_set.h>

namespace vug::volume {

/// The level set with distances at least up to this half-width, in metres. Added values continue
/// those of the band with the slope 1 (OpenVDB's dilateSdf); values in the band stay.
LevelSet with_half_width(const LevelSet& level_set, double half_width);

}  // namespace vug::volume
