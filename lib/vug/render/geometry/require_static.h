// What shines must stand still.
#pragma once

#include <vug/render/scene.h>

namespace vug::render {

/// Triangles that shine are lamps, which have one place. Error(bad_input) where the object shines
/// and moves.
void require_static(const Object& object);

}  // namespace vug::render
