// SPDX-License-Identifier: Apache-2.0
// Tests for folded polygons after their vertices moved.
#pragma once

#include <vug/meshing/faces.h>
#include <vug/meshing/project.h>

namespace vug::meshing {

/// Whether the triangle at corner k flipped, or lost nearly all its area, when its vertices moved
/// from `before` to `after`.
bool is_flipped(const Face& face, uint32_t k, const std::vector<Vec3d>& before,
                const std::vector<Vec3d>& after);

/// The centroid of the triangle at corner k.
Vec3d corner_centroid(const Face& face, uint32_t k, const std::vector<Vec3d>& points);

/// Whether the triangle at corner k lies on the surface but faces inwards according to the field at
/// its centroid. This detects folds next to sharp creases, which the orientation before the move
/// does not reveal.
bool faces_backwards(const Face& face, uint32_t k, const std::vector<Vec3d>& points,
                     const SurfacePoint& middle, double voxel);

}  // namespace vug::meshing
