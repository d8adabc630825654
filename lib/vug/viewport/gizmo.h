// SPDX-License-Identifier: Apache-2.0
// The lights and cameras of a scene as places with directions, which pictures mark by symbols.
#pragma once

#include <vug/loading/load.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::viewport {

struct Gizmo {
  std::string kind;  ///< "light" or "camera".
  std::string name;
  Vec3d position{0, 0, 0};
  std::optional<Vec3d> direction;  ///< Unit; nothing for lights that shine to all sides.
  SourceLocation where;            ///< The declaration; unknown if the text has none.
};

/// The lights that are not infinite, and the cameras, in the order of the text.
std::vector<Gizmo> gizmos_of(const loading::Loaded& loaded);

}  // namespace vug::viewport
