// SPDX-License-Identifier: Apache-2.0
// Bodies with a nearly level surface in passages, made of prisms between neighbouring points.
#pragma once

#include <vug/passages/water/floor_plan.h>
#include <vug/passages/water/polytopes.h>

#include <vector>

namespace vug::passages {

/// Metres by which neighbouring prisms overlap.
inline constexpr double kSeam = 0.05;

/// A point of a passage with the height of the surface there.
struct SurfacePoint {
  FloorPoint place;
  Vec3d position{0.0};  ///< See FloorNode.
  double top = 0;
  double bottom = 0;
};

struct SurfaceOptions {
  double overlap = 0.5;        ///< Metres by which the body extends into the walls and the floor.
  bool rounded_start = false;  ///< Whether it extends beyond the first point, as caps do.
  bool rounded_end = false;
};

/// Appends the body along a part of a passage, whose surface is level across.
void append_body(const std::vector<SurfacePoint>& points, const SurfaceOptions& options,
                 std::vector<Polytope>& out);

}  // namespace vug::passages
