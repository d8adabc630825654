// SPDX-License-Identifier: Apache-2.0
// Rings of waves around places where drops fall into still water.
#pragma once

#include <vug/field/noise.h>

#include <vector>

namespace vug::passages {

struct DropRingsOptions {
  std::vector<Vec3d> points;  ///< Where drops fall; their heights do not matter.
  double wavelength = 0.025;  ///< Metres.
  double reach = 0.4;         ///< Largest radius of the rings, metres.
  uint64_t seed = 0;          ///< Seed of the times since the last drops.
};

/// Heights of the water in -1..1: around each point a packet of three waves, whose radius is random
/// up to `reach` and whose height falls with the root of the radius, as that of circular waves.
/// Where packets cross, their heights add up. Error(bad_input) for more than 1000 points.
field::Noise drop_rings(const DropRingsOptions& options);

}  // namespace vug::passages
