// What moves while the shutter is open, and from frame to frame.
#pragma once

#include <vug/picture/picture.h>

namespace vug::picture {

/// The shot while the shutter of the plan's camera is open, by PictureOptions::moment; none where
/// it is closed or nothing moves.
building::Moments shutter_moments(const shot::Shot& shot, const PictureOptions& options,
                                  const shot::RenderPlan& plan);

/// The plan's camera as it goes through the moments; as it is where it stands still.
render::CameraPtr camera_in_motion(const building::Moments& moments, const PictureOptions& options,
                                   const shot::RenderPlan& plan);

/// The scene from its frame to the next, for the layer `motion`; null where nothing moves. The
/// plan's camera is that of the frame, before `camera_in_motion`.
render::FrameStepPtr frame_step(building::Builder& builder, const PictureOptions& options,
                                const shot::RenderPlan& plan);

}  // namespace vug::picture
