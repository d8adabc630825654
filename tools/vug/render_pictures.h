// SPDX-License-Identifier: Apache-2.0
// The pictures of a run of `vug render`: their options, files and checks before the work.
#pragma once

#include "scene_at_frame.h"
#include "scene_options.h"
#include "setting_options.h"

#include <vug/loading/placement/check.h>
#include <vug/picture/exposure.h>
#include <vug/picture/render_job.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::cli {

/// The options of `vug render`. File names may contain a placeholder for the frame.
struct RenderOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string output;
  std::string products;
  std::string tile, samples, frames, eye;
  std::string part, checkpoint, preview, guiding;
  std::string ocio;
  std::vector<std::string> renders;
  bool anyway = false, untested = false;
  bool part_requests = false;  ///< The parts are those of the lines of the standard input.
  SettingOptions settings;
  picture::PictureOptions picture;
  picture::RenderOptions render;
};

/// Adds the options that determine the picture, without those of files, parts and frames.
void add_picture_options(CLI::App& app, RenderOptions& options);

/// The choice of the picture from the texts of these options.
picture::PictureOptions picture_options(const RenderOptions& options);

/// One picture of a run. The options contain the names of its files.
struct PlannedPicture {
  RenderOptions options;
  picture::PicturePlan plan;
};

/// Whether the guiding file is the only product of the command line.
bool learns_only(const RenderOptions& options);

/// The options with the frame number inserted into file names that contain a placeholder.
RenderOptions with_frame_number(const RenderOptions& options, int frame);

/// The options for one frame of a sequence. Error(bad_input) for a name without a placeholder.
RenderOptions options_at_frame(const RenderOptions& options, int frame);

/// The chosen pictures of the scene, or of one frame of a sequence. Error(bad_input) if a file
/// cannot belong to several.
std::vector<PlannedPicture> plan_pictures(const RenderOptions& options, const shot::Shot& shot,
                                          std::optional<int> frame = {});

/// Refuses a scene whose camera or lights are in rock, whose props float or whose voids are filled.
void require_placement(const PlannedPicture& picture, const loading::Loaded& loaded,
                       loading::Accuracy accuracy);

/// Checks the files and, exactly, the placement of all pictures before the first is rendered.
void check_pictures(const std::vector<PlannedPicture>& pictures, SceneAtFrame& scene,
                    Progress& progress);

/// Removes the pictures that an earlier run has finished; their exposures can be the locked ones.
void skip_finished(std::vector<PlannedPicture>& pictures, const shot::Shot& shot,
                   picture::ExposureLock& lock);

}  // namespace vug::cli
