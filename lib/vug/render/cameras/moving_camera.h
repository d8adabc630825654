// A camera that moves while the shutter is open.
#pragma once

#include <vug/render/camera.h>

#include <vector>

namespace vug::render {

/// The camera that goes through all of these, evenly in time from the opening of the shutter to its
/// close. In between, the rays of the two nearest for the same place on film and lens are blended:
/// exact where a camera only changes its place. The camera itself where there is but one.
/// Error(bad_input): none.
CameraPtr moving_camera(std::vector<CameraPtr> moments);

}  // namespace vug::render
