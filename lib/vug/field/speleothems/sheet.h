// SPDX-License-Identifier: Apache-2.0
// Thin sheets of stone: a grid of triangles with a thickness at each corner.
#pragma once

#include <vug/field/field.h>

#include <string>
#include <vector>

namespace vug::field {

/// Corners in rows of the same length. Metres.
struct Sheet {
  std::vector<Vec3d> corners{};
  std::vector<double> radii{};  ///< Half the thickness at each corner.
  int across = 2;               ///< Corners of a row, at least 2.
};

/// The solid within the radius of a sheet. The value at a point is the least over the triangles of
/// the distance to their nearest point, less the radius there: exact for equal radii, else nearly.
Field sheet_field(const std::string& name, const Sheet& sheet);

}  // namespace vug::field
