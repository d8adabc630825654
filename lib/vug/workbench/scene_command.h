// SPDX-License-Identifier: Apache-2.0
// The commands of the scene bench; see workbench/command.h.
#pragma once

#include <vug/workbench/command.h>
#include <vug/workbench/scene_bench.h>

namespace vug::workbench {

using SceneCommand = CommandOf<SceneBench>;

/// The commands in scene_commands/; generated from the list in CMakeLists.txt.
const std::vector<const SceneCommand*>& scene_commands();
/// Error(bad_input) with the nearest name for an unknown command.
const SceneCommand& find_scene_command(const std::string& name);

/// Runs a line and returns its command; null for an empty line and a comment, which do nothing.
/// Errors are those of run_command for a facade bench.
const SceneCommand* run_command(SceneBench& bench, const std::string& line);

/// Reasons that several commands share.
std::string without_scene(const SceneBench& bench);
std::string without_picture(const SceneBench& bench);
std::string without_renders(const SceneBench& bench);

}  // namespace vug::workbench

/// Opens the one definition that the file of a command exports; see VUG_EXPORT_KIND.
#define VUG_SCENE_COMMAND(name) VUG_EXPORT_KIND(vug::workbench, SceneCommand, name##_scene_command)
