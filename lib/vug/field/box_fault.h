// SPDX-License-Identifier: Apache-2.0
// The check of a box that is given by two corners.
#pragma once

#include <vug/base/value.h>

#include <fmt/format.h>

#include <string>

namespace vug::field {

/// An error message about the parameters `from` and `to`, or an empty string.
inline std::string box_fault(const Vec3d& from, const Vec3d& to) {
  const Vec3d size = to - from;
  for (int axis = 0; axis < 3; ++axis)
    if (!(size[axis] > 0))
      return fmt::format(
          "'from' must be less than 'to' in x, y and z, but in {} it is {} and 'to' is {}",
          "xyz"[axis], quantity_text(from[axis], Dimension::length),
          quantity_text(to[axis], Dimension::length));
  return "";
}

}  // namespace vug::field
