// What a plant stands on: the ground below a point of the plan, of a field or of a mesh.
#pragma once

#include <vug/field/field.h>
#include <vug/flora/plot.h>
#include <vug/mesh/mesh.h>

#include <functional>
#include <optional>

namespace vug::flora {

/// Where a stem meets the ground.
struct GroundPoint {
  Vec3d position{0, 0, 0};
  Vec3d normal;  ///< Unit, out of the ground.
  double clearance =
      kInfinity;  ///< Metres straight up to the next surface, as far as was asked for.
};

/// Looks straight down at (x, z); nothing where no ground is met. For several threads.
using Ground = std::function<std::optional<GroundPoint>(const Vec2d& at)>;

struct GroundOptions {
  double from = kInfinity;  ///< Height that is looked down from; infinite: above all of it.
  double headroom = 0;      ///< Metres above a foot that are looked through for `room`.
};

/// The first surface below `from` of a solid; nothing where that height lies inside of it. Steps go
/// by the field's Lipschitz bound, so that none is jumped over that is thicker than a millimetre.
/// Error(bad_input): a solid without an end above, and no `from`.
Ground ground_of(const field::Field& solid, const GroundOptions& options = {});

/// The highest triangle below `from` that faces up or down; the mesh must outlive it.
Ground ground_of(const mesh::MeshPtr& mesh, const GroundOptions& options = {});

/// Level ground at a height.
Ground level_ground(double height = 0);

}  // namespace vug::flora
