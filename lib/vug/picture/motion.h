// SPDX-License-Identifier: Apache-2.0
// Motion while the shutter is open, and from frame to frame.
#pragma once

#include <vug/picture/picture.h>

namespace vug::picture {

/// The shot at times while the shutter of the plan's camera is open, from PictureOptions::source;
/// empty if the shutter is closed or the scene is static.
building::TimeSamples shutter_samples(const shot::Shot& shot, const PicturePlan& plan);

/// The plan's camera across the time samples; the camera itself if it is static.
render::CameraPtr animated_camera(const building::TimeSamples& time_samples,
                                  const PicturePlan& plan);

/// The motion from the frame to the next one, for the AOV `motion`; null if the scene is static.
render::MotionStepPtr motion_step(building::Builder& builder, const PicturePlan& plan);

}  // namespace vug::picture
