// How a polygon that moved shows that it is folded.
#pragma once

#include <vug/meshing/faces.h>
#include <vug/meshing/project.h>

namespace vug::meshing {

/// Whether the triangle at corner k turned over, or lost nearly all its area, on the way from the
/// places `before` to `after`.
bool is_flipped(const Face& face, uint32_t k, const std::vector<Vec3d>& before,
                const std::vector<Vec3d>& after);

/// The middle of the triangle at corner k.
Vec3d corner_centroid(const Face& face, uint32_t k, const std::vector<Vec3d>& points);

/// Whether the triangle at corner k lies on the surface but faces inwards there, as the field
/// says at its middle. Sees folds beside sharp creases, which the polygon's direction before the
/// move does not tell.
bool faces_backwards(const Face& face, uint32_t k, const std::vector<Vec3d>& points,
                     const SurfacePoint& middle, double voxel);

}  // namespace vug::meshing
