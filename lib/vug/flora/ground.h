// SPDX-License-Identifier: Apache-2.0
// Ground queries for planting: the surface of a field or mesh below a point of the plan.
#pragma once

#include <vug/field/field.h>
#include <vug/flora/plot.h>
#include <vug/mesh/mesh.h>

#include <functional>
#include <optional>

namespace vug::flora {

/// A point on the ground where a stem can be placed.
struct GroundPoint {
  Vec3d position{0, 0, 0};
  Vec3d normal;  ///< Unit normal, pointing out of the ground.
  double clearance =
      kInfinity;  ///< Metres straight up to the next surface, within GroundOptions::headroom.
};

/// Looks straight down at (x, z); empty if there is no ground. Thread-safe.
using Ground = std::function<std::optional<GroundPoint>(const Vec2d& at)>;

struct GroundOptions {
  double from = kInfinity;  ///< Height from which it looks down; infinite: above everything.
  double headroom = 0;      ///< Metres above the ground that are searched for `clearance`.
};

/// The first surface of a solid below `from`; empty if that height is inside the solid. Marches
/// with the field's Lipschitz bound, so surfaces thicker than a millimetre are not missed.
/// Error(bad_input) for a solid without an upper bound if `from` is infinite.
Ground ground_of(const field::Field& solid, const GroundOptions& options = {});

/// The highest triangle below `from` that is not vertical; the mesh must outlive the result.
Ground ground_of(const mesh::MeshPtr& mesh, const GroundOptions& options = {});

/// Horizontal ground at a height.
Ground level_ground(double height = 0);

}  // namespace vug::flora
