// SPDX-License-Identifier: Apache-2.0
// The cameras and the size that define the micro-displacement of a picture.
#pragma once

#include <vug/building/dice_objects.h>
#include <vug/picture/picture_plan.h>

namespace vug::picture {

/// The camera of the plan, at each of the time samples if it moves, with both eyes of a stereo
/// camera, and the size of the whole picture: tiles, crops, ranges of samples and both views of a
/// stereo picture get the same meshes. `otherwise` is the camera of a scene without cameras.
building::DicingView dicing_view(const shot::Shot& shot, const PicturePlan& plan,
                                 const building::TimeSamples& time_samples,
                                 const render::CameraPtr& otherwise);

}  // namespace vug::picture
