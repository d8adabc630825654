// A lamp of a scene that stands in another scene.
#pragma once

#include <vug/base/transform.h>
#include <vug/render/light.h>

namespace vug::render {

/// The lamp moved, turned, mirrored and made larger or smaller alike in all directions, with the
/// radiance it has: a lamp of twice the size sends out four times the light. Error(bad_input) for
/// maps that stretch it unevenly. Not for skies.
LightPtr transformed_light(LightPtr light, const Transform& place, LightLinking linking);

}  // namespace vug::render
