// What moves while the shutter is open, and from frame to frame.
#pragma once

#include <vug/picture/picture.h>

namespace vug::picture {

/// The shot while the shutter of the plan's camera is open, by PictureOptions::moment; none where
/// it is closed or nothing moves.
building::TimeSamples shutter_samples(const shot::Shot& shot, const PictureOptions& options,
                                      const shot::RenderPlan& plan);

/// The plan's camera as it goes through the moments; as it is where it stands still.
render::CameraPtr animated_camera(const building::TimeSamples& time_samples,
                                  const PictureOptions& options, const shot::RenderPlan& plan);

/// The scene from its frame to the next, for the layer `motion`; null where nothing moves. The
/// plan's camera is that of the frame, before `animated_camera`.
render::MotionStepPtr motion_step(building::Builder& builder, const PictureOptions& options,
                                const shot::RenderPlan& plan);

}  // namespace vug::picture
