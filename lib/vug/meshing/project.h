// The way from a point near a field's surface onto it.
#pragma once

#include <vug/field/field.h>

namespace vug::meshing {

/// A point near or on the surface and what the field says there.
struct SurfacePoint {
  Vec3d point;
  Vec3d normal{0, 0, 0};        ///< Unit gradient; zero where the field has none.
  double residual = kInfinity;  ///< |f| / |grad f|: distance from the surface to first order.
};

/// What the field says at p.
SurfacePoint probe(const field::Field& field, const Vec3d& p);

struct ProjectOptions {
  double reach = 1;      ///< Furthest from the start, metres.
  double tolerance = 0;  ///< Residual that is good enough, metres.
  int steps = 10;
};

/// Newton steps along the gradient, each at most half the reach; the best point met on the way.
/// On creases the steps alternate between the branches and close in on both.
SurfacePoint project(const field::Field& field, const Vec3d& start, const ProjectOptions& options);

}  // namespace vug::meshing
