// SPDX-License-Identifier: Apache-2.0
// The way out of rock, for hints.
#pragma once

#include <vug/loading/placement/set.h>

#include <optional>

namespace vug::loading {

struct NearestAir {
  double distance = 0;  ///< From the point to the surface.
  Vec3d position;       ///< A little beyond the surface.
  std::string side;     ///< The direction in words: "above", "towards +x and -z".
};

/// The nearest air in 26 directions within 100 m; nothing if there is none. Takes thousands of
/// evaluations.
std::optional<NearestAir> nearest_air(const Set& set, const Vec3d& p, IsOpen is_open,
                                      Accuracy accuracy);

}  // namespace vug::loading
