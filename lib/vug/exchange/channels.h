// What of a look may vary over a mesh, and the attributes that hold it there.
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

/// "Cd" (the body's colour), "roughness", "wetness", "metallic", "transmission", "opacity",
/// "through", "emission".
const std::vector<Channel>& channels();

/// Whether vectors of that attribute are colours, which do not turn with the axes.
bool is_color(std::string_view attribute);

}  // namespace vug::exchange
