// SPDX-License-Identifier: Apache-2.0
// Options of `vug survey --shoot`: the survey of a scene's passages.
#pragma once

#include "scene_options.h"

#include <vug/passages/simulated_survey.h>

namespace vug::cli {

struct ShootOptions {
  SceneOptions scene;
  std::string network;
  std::string volume;
  passages::SimulationOptions simulation;

  /// `file`: the option that names a survey file, which --shoot replaces.
  void add_to(CLI::App& app, CLI::Option* file);
  bool given() const { return !scene.scene.empty(); }
  /// Loads the scene and surveys the volume, with its walls as scraps if one of the outputs is a
  /// .lox file; prints diagnostics on stderr. Error(bad_input) for
  /// other files, unknown names, volumes without a field, and outputs that the scene reads.
  survey::Survey survey(const std::vector<std::filesystem::path>& outputs) const;
};

}  // namespace vug::cli
