#include <vug/base/error.h>
#include <vug/render/geometry/require_static.h>

#include <fmt/format.h>

namespace vug::render {

void require_static(const Object& object) {
  const bool shines = !is_black(object.emission) || (object.material && object.material->is_emissive());
  if (shines && object.instance && object.instance->moves())
    throw Error(ErrorCode::bad_input,
                fmt::format("object '{}' shines and moves, which cannot be rendered", object.name),
                {}, "keep it still, take its emission away, or close the camera's shutter");
}

}  // namespace vug::render
