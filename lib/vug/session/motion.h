// What moves while the shutter is open, and from frame to frame.
#pragma once

#include <vug/session/picture.h>

namespace vug::session {

/// The shot while the shutter of the plan's camera is open, by PictureOptions::moment; none where
/// it is closed or nothing moves.
Moments shutter_moments(const Shot& shot, const PictureOptions& options, const RenderPlan& plan);

/// The plan's camera as it goes through the moments; as it is where it stands still.
render::CameraPtr camera_in_motion(const Moments& moments, const PictureOptions& options,
                                   const RenderPlan& plan);

/// The scene from its frame to the next, for the layer `motion`; null where nothing moves. The
/// plan's camera is that of the frame, before `camera_in_motion`.
render::FrameStepPtr frame_step(Builder& builder, const PictureOptions& options,
                                const RenderPlan& plan);

}  // namespace vug::session
