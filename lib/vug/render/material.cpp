// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/look.h>
#include <vug/render/material.h>

namespace vug::render {

exchange::Look Material::look(const Surface& surface) const {
  BsdfMemory memory;
  exchange::Look look;
  look.base_color = Vec3d(at(surface, {0, 0, 1}, memory).albedo());
  return look;
}

}  // namespace vug::render
