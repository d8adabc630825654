// SPDX-License-Identifier: Apache-2.0
// The properties of a look that may vary over a mesh, and the attributes that store them.
#pragma once

#include <vug/exchange/look.h>

#include <string_view>
#include <vector>

namespace vug::exchange {

/// Exactly one of the members is set; colours have arity 3.
struct Channel {
  std::string_view attribute;
  double Look::*number = nullptr;
  Vec3d Look::*color = nullptr;

  int arity() const { return color ? 3 : 1; }
};

/// "Cd" (the base colour), "roughness", "wetness", "metallic", "transmission", "opacity",
/// "through", "emission".
const std::vector<Channel>& channels();

/// Whether vectors of the attribute are colours, which do not rotate with the axes.
bool is_color(std::string_view attribute);

}  // namespace vug::exchange
