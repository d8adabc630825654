// SPDX-License-Identifier: Apache-2.0
// Rays into the prepared scene: views, free distances and the floor.
#pragma once

#include <vug/render/prepared_scene.h>
#include <vug/scout/view.h>

#include <optional>

namespace vug::scout {

/// The surface on a ray; `kSky` if it hits none.
Seen look_along(const render::PreparedScene& world, const Vec3d& from, const Vec3d& direction);

/// The view of a camera through the centres of its pixels.
View trace_view(const render::PreparedScene& world, const render::Camera& camera,
                int width = kViewWidth, int height = kViewHeight);

/// The distance to the nearest surface in 26 directions; 0 if the point is inside a solid, which
/// more than half of the rays see from the back. Infinite in the open.
double clearance(const render::PreparedScene& world, const Vec3d& p);

/// The point of the floor below `p`, at most `reach` metres down. None over a wall steeper than
/// 50 degrees or the back of a surface.
std::optional<Vec3d> floor_below(const render::PreparedScene& world, const Vec3d& p, double reach);

}  // namespace vug::scout
