// SPDX-License-Identifier: Apache-2.0
// Basins of a floor: how high water stands in them, and where it runs over.
#pragma once

#include <vug/field/field.h>

#include <optional>

namespace vug::drips {

struct BasinOptions {
  double cell = 0.1;  ///< Side in metres of the columns whose heights are compared.
  int most = 4000;    ///< Columns that are examined; larger basins count as open.
  Box3d region = infinite_box();
};

struct Basin {
  double level = 0;  ///< Height of the water when it runs over.
  double area = 0;   ///< Area of the water in m2.
  Vec3d spill{0.0};  ///< The point behind the lip, from which it runs on.
};

/// The basin around a low of the floor; nothing if the place lies on a slope, or if the water
/// leaves the region before it runs over.
std::optional<Basin> basin_at(const field::Field& rock, const Vec3d& low,
                              const BasinOptions& options);

}  // namespace vug::drips
