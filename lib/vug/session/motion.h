// What moves while the shutter is open.
#pragma once

#include <vug/session/picture.h>

namespace vug::session {

/// The plan's camera as it moves while its shutter is open, at moments that PictureOptions::moment
/// gives; as it is where the shutter is closed or it stands still.
render::CameraPtr camera_in_motion(const Shot& shot, const PictureOptions& options,
                                   const RenderPlan& plan);

/// The scene from its frame to the next, for the layer `motion`; null where nothing moves. The
/// plan's camera is that of the frame, before `camera_in_motion`.
render::FrameStepPtr frame_step(const Shot& shot, const PictureOptions& options,
                                const RenderPlan& plan);

}  // namespace vug::session
