// SPDX-License-Identifier: Apache-2.0
// Search for the zero of a field on short lines.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::meshing {

/// A segment through `start` that is searched for the surface. Lengths are in metres.
struct FieldLine {
  Vec3d start;
  Vec3d direction;       ///< Unit vector that points out of the solid.
  double reach = 0;      ///< The search ends at this distance from the start, on both sides.
  double tolerance = 0;  ///< Sufficient distance from the surface, to first order.
};

/// A point on the surface.
struct PlacedPoint {
  Vec3d point;   ///< The start, if nothing was found.
  Vec3d normal;  ///< Unit gradient of the field; the line's direction, if nothing was found.
  bool found = false;
};

/// Finds on each line the zero that is nearest to the start among those where the field changes
/// from inside to outside along the direction: Newton steps until the sign changes, then Newton
/// steps and bisection inside the bracket. `error` is the permitted deviation of single precision
/// in metres; see SurfaceProjector.
std::vector<PlacedPoint> place_on_field(const field::Field& field,
                                        const std::vector<FieldLine>& lines, double error);

}  // namespace vug::meshing
