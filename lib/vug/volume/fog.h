// Fog volumes: density 0 outside, rising to 1 inside a solid.
#pragma once

#include <vug/volume/level_set.h>

namespace vug::volume {

struct FogOptions {
  double falloff = 0;  ///< Depth at which density reaches 1, metres; 0 or more than the band
                       ///< holds: the whole inner half of the band.
};

/// Density grid of the level set's inside; the class is `fog`.
Grid fog(const LevelSet& level_set, const FogOptions& options = {});

}  // namespace vug::volume
