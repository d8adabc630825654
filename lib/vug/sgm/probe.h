// SPDX-License-Identifier: Apache-2.0
// Queries on a field without a grid: first hit of a ray, extreme points, any inner point.
#pragma once

#include <vug/field/field.h>

#include <optional>

namespace vug::sgm {

/// The smallest t in [0, length] (metres) at which origin + t * direction (unit) is inside or on
/// the solid. Steps have the size value / Lipschitz constant and at least length / 2048, so thinner
/// solids may be missed if the field is not a distance. The root is bisected to 1e-15 of the
/// length.
std::optional<double> first_hit(const field::Field& field, const Vec3d& origin,
                                const Vec3d& direction, double length);

/// The solid's extreme point along `axis` (0, 1, 2), upwards for `sign` = 1, downwards for -1: a 17
/// x 17 grid of rays over the bounds, refined around the best ray (a local search, which may select
/// any of several small features between the rays). Bounds must be finite. Among points that are
/// extreme to 1e-6 of the size, it returns the one nearest to the centre line.
std::optional<Vec3d> support_point(const field::Field& field, int axis, int sign);

/// A point at least 1e-9 of the size below the surface, or nothing for an empty solid. Bisects the
/// bounds and discards boxes without solid by the Lipschitz bound, until a box is below 1/1024 of
/// the size. Infinite bounds are cut at 100 m from the origin.
std::optional<Vec3d> inner_point(const field::Field& field);

}  // namespace vug::sgm
