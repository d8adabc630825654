// Questions to a field that need no grid: first hit of a ray, extreme points, any inner point.
#pragma once

#include <vug/field/field.h>

#include <optional>

namespace vug::sgm {

/// Smallest t in [0, length] (metres) at which origin + t * direction (unit) is inside or on the
/// solid. Steps by value / Lipschitz constant, at least length / 2048, so a solid that the ray
/// meets for less than that may be missed where the field is no distance. The root is
/// bisected to 1e-15 of the length.
std::optional<double> first_hit(const field::Field& field, const Vec3d& origin,
                                const Vec3d& direction, double length);

/// The solid's extreme point along `axis` (0, 1, 2), upwards for `sign` = 1, downwards for -1: a
/// 17 x 17 grid of rays over the bounds, refined around the best (a local search: of specks between
/// the rays it may take any); bounds must be finite. Of points that are extreme to 1e-6 of the size
/// the one nearest to the centre line.
std::optional<Vec3d> support_point(const field::Field& field, int axis, int sign);

/// A point at least 1e-9 of the size below the surface, or nothing when there is none: bisection of
/// the bounds, boxes without solid dropped by the Lipschitz bound, until a box is below 1/1024 of
/// the size. Infinite bounds are cut at 100 m from the origin.
std::optional<Vec3d> inner_point(const field::Field& field);

}  // namespace vug::sgm
