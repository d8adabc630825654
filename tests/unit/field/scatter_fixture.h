// SPDX-License-Identifier: Apache-2.0
// The scatter of small forms on a rock, for tests.
#pragma once

#include <vug/field/speleothems/surface_places.h>

namespace vug::field {

/// On the surface within a cube about the origin.
inline SurfaceScatter scatter_on(const Field& rock, double half_width, double spacing) {
  SurfaceScatter scatter;
  scatter.field = rock;
  scatter.from = Vec3d(-half_width);
  scatter.to = Vec3d(half_width);
  scatter.spacing = spacing;
  return scatter;
}

}  // namespace vug::field
