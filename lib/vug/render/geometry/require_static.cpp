// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/render/geometry/require_static.h>

#include <fmt/format.h>

namespace vug::render {

void require_static(const Object& object) {
  const bool is_emissive =
      !is_black(object.emission) || (object.material && object.material->is_emissive());
  if (is_emissive && object.instance && object.instance->moves())
    throw Error(
        ErrorCode::bad_input,
        fmt::format("object '{}' is emissive and moves, which is not supported", object.name), {},
        "keep it static, remove its emission, or set the camera's shutter to 0");
}

}  // namespace vug::render
