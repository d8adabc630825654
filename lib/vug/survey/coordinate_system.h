// SPDX-License-Identifier: Apache-2.0
// Names of coordinate systems as definitions for PROJ.
#pragma once

#include <vug/base/vec.h>

#include <optional>
#include <string>

namespace vug::survey {

struct CoordinateSystem {
  std::string definition;  ///< For PROJ, e.g. "EPSG:27700"; empty for local metres.
  Vec3d origin{0.0};       ///< Added to coordinates, e.g. the corner of a square of the grid.
};

/// The system of a name, see Geodesy; nothing for a name of another form.
std::optional<CoordinateSystem> coordinate_system(const std::string& name);

}  // namespace vug::survey
