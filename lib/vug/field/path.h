// SPDX-License-Identifier: Apache-2.0
// Solids along a path: the union of one solid for each segment.
#pragma once

#include <vug/field/boolean.h>

#include <string>
#include <vector>

namespace vug::field {

/// An error message about the points of a path, or an empty string.
inline std::string path_fault(const std::vector<Vec3d>& path) {
  return path.size() < 2 ? "a path needs at least two points" : "";
}

/// The length of a path in metres.
inline double path_length(const std::vector<Vec3d>& path) {
  double length = 0;
  for (size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).length();
  return length;
}

/// The union of `segment(from, to, index)` over the segments of a path of at least two points; the
/// solid itself if there is one segment.
template <class Segment>
Field along_path(const std::vector<Vec3d>& path, const Segment& segment) {
  std::vector<Field> solids;
  for (size_t i = 0; i + 1 < path.size(); ++i) solids.push_back(segment(path[i], path[i + 1], i));
  return unite(std::move(solids));
}

}  // namespace vug::field
