// SPDX-License-Identifier: Apache-2.0
// The raw polygons of a level set from OpenVDB's volume-to-mesh.
#pragma once

#include <vug/volume/level_set.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::volume {

struct PolygonOptions {
  double iso = 0;         ///< Isovalue of the surface, metres.
  double adaptivity = 0;  ///< 0..1: degree to which flat regions are merged into larger polygons.
};

/// World space, metres. Corners are anticlockwise seen from outside (air).
struct Polygons {
  std::vector<Vec3f> points;
  std::vector<std::array<uint32_t, 4>> quads;
  std::vector<std::array<uint32_t, 3>> triangles;
};

/// Polygonizes a level set, with identical polygons in identical order for any number of threads.
Polygons polygons_of(const LevelSet& level_set, const PolygonOptions& options = {});

}  // namespace vug::volume
