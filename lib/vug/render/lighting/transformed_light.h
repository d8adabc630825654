// SPDX-License-Identifier: Apache-2.0
// Lights of instanced scenes, transformed to the scene that contains the instance.
#pragma once

#include <vug/base/transform.h>
#include <vug/render/light.h>

namespace vug::render {

/// The light with a similarity transform (rotation, reflection, uniform scale, translation) applied
/// and its radiance unchanged: a light of twice the size emits four times the power.
/// Error(bad_input) for a non-uniform scale. Not for infinite lights.
LightPtr transformed_light(LightPtr light, const Transform& place, LightLinking linking);

}  // namespace vug::render
