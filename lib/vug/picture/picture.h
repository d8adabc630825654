// SPDX-License-Identifier: Apache-2.0
// Converts a shot and the plan of a picture to the scene and options of the renderer.
#pragma once

#include <vug/building/flat_scene.h>
#include <vug/picture/picture_file.h>
#include <vug/picture/picture_plan.h>

namespace vug::picture {

/// Builds the renderer's scene: objects, lights, medium and camera. A shot without objects shows
/// its meshes with a grey material; a shot without lights gets a uniform sky, unless the plan
/// selects the lights.
render::Scene build_scene(building::Builder& builder, const PicturePlan& plan,
                          const building::TimeSamples& time_samples = {});

/// All inputs of a rendering.
struct PictureJob {
  render::Scene scene;
  render::Options options;
  PictureOutput output;
};

/// Builds all inputs. `whole_film`: the rendering keeps the sums of all pixels in memory.
/// Error(too_large) for a picture that does not fit into memory.
PictureJob prepare_picture(building::Builder& builder, const PicturePlan& plan, bool whole_film);

/// The header of partial renders and checkpoints, which identifies the picture.
render::PartialRenderHeader file_header(const PictureJob& job, const shot::Shot& shot,
                                        const PicturePlan& plan);

}  // namespace vug::picture
