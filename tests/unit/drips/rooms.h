// SPDX-License-Identifier: Apache-2.0
// Rock for the tests of drips.
#pragma once

#include <vug/drips/build_graph.h>
#include <vug/field/boolean.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>

#include <algorithm>
#include <vector>

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

/// Steep joints in one direction.
inline Planes joints(double spacing = 2, double azimuth = 0.6) {
  karst::Geology geology;
  geology.fractures.push_back({.azimuth = azimuth, .dip = 1.45, .spacing = spacing});
  return Planes(geology, 1);
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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
