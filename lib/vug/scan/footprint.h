// SPDX-License-Identifier: Apache-2.0
// Points of a cloud projected onto a plane, and the extent of their largest group.
#pragma once

#include <vug/scan/plane.h>

#include <functional>

namespace vug::scan {

/// Projections of the points whose signed distance in front of the plane is accepted.
std::vector<Vec2d> on_plane(const PointCloud& cloud, const PlaneFrame& frame,
                            const std::function<bool(double)>& accepts);

/// Bounding box of the largest connected group of points. Groups are more than a metre apart.
Imath::Box2d extent(const std::vector<Vec2d>& points);

}  // namespace vug::scan
