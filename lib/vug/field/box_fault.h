// SPDX-License-Identifier: Apache-2.0
// The check of a box that is given by two corners.
#pragma once

#include <vug/base/vec.h>

#include <string>

namespace vug::field {

/// An error message about the parameters `from` and `to`, or an empty string.
inline std::string box_fault(const Vec3d& from, const Vec3d& to) {
  const Vec3d size = to - from;
  const bool valid = size.x > 0 && size.y > 0 && size.z > 0;
  return valid ? "" : "'from' must be less than 'to' in x, y and z";
}

}  // namespace vug::field
