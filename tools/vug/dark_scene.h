// SPDX-License-Identifier: Apache-2.0
// The lamps of a cave whose scene has no light.
#pragma once

#include "render_pictures.h"

namespace vug::cli {

/// If the scene has no light and the camera of the picture is in a closed cave, where the default
/// sky is not seen, adds the lamps that the scout chooses for this camera to the scene's lights,
/// and prints them as text. Returns whether it did.
bool light_dark_scene(const PlannedPicture& picture, SceneAtFrame& scene);

}  // namespace vug::cli
