// SPDX-License-Identifier: Apache-2.0
// Rock for the tests of drips.
#pragma once

#include <vug/drips/build_graph.h>
#include <vug/field/boolean.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>

namespace vug::drips {

/// A hall of that width and depth between the heights -2 and about 2, whose roof slopes to +x.
inline field::Field hall(double width = 6, double slope = 0.2, double depth = 6) {
  const field::Field box = field::make("box", {{"size", Vec3d(width, 4, depth)}});
  const field::Field roof =
      field::make("half_space", {{"normal", Vec3d(slope, 1, 0)}, {"offset", 1.0}});
  return field::complement(field::intersect({box, roof}));
}

/// The same with rough walls.
inline field::Field cave(double width = 6, double slope = 0.2, double depth = 6) {
  return field::make("displace",
                     {{"field", field::as_value(hall(width, slope, depth))},
                      {"noise", field::as_value(field::make_noise("fbm", {{"scale", 0.8}}))},
                      {"amount", 0.15}});
}

/// Options for the drips in the middle of such a room, that far from its centre.
inline GraphOptions graph_options(double half = 3) {
  GraphOptions o;
  o.from = Vec3d(-half, -3, -half);
  o.to = Vec3d(half, 3, half);
  o.spacing = 0.4;
  return o;
}

}  // namespace vug::drips
