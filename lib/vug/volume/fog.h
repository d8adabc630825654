// SPDX-License-Identifier: Apache-2.0
// Fog volumes: density 0 outside a solid, rising to 1 inside.
#pragma once

#include <vug/volume/level_set.h>

namespace vug::volume {

struct FogOptions {
  double falloff = 0;  ///< Depth at which density reaches 1, metres; 0 or a value beyond the band:
                       ///< the whole inner half of the band.
};

/// The density grid of the level set's inside, with class `fog`.
Grid fog(const LevelSet& level_set, const FogOptions& options = {});

}  // namespace vug::volume
