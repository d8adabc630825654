// SPDX-License-Identifier: Apache-2.0
// Camera motion while the shutter is open.
#pragma once

#include <vug/render/camera.h>

#include <vector>

namespace vug::render {

/// A camera that moves through all `moments`, evenly spaced from the opening of the shutter to its
/// close. In between, the two nearest rays for the same film and lens position are interpolated,
/// which is exact for pure translation. A single camera is returned unchanged. Throws
/// Error(bad_input) without cameras.
CameraPtr moving_camera(std::vector<CameraPtr> moments);

}  // namespace vug::render
