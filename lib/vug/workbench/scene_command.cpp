// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {

const SceneCommand& find_scene_command(const std::string& name) {
  return find_command_in(scene_commands(), name);
}

const SceneCommand* run_command(SceneBench& bench, const std::string& line) {
  CommandCall call;
  const SceneCommand* command = parse_command<SceneBench>(scene_commands(), bench, line, call);
  if (!command) return nullptr;
  command->run(bench, call);
  if (command->changes && bench.journal) bench.journal(line);
  return command;
}

std::string without_scene(const SceneBench& bench) {
  return bench.has_document() ? "" : "no scene is open";
}

std::string without_picture(const SceneBench& bench) {
  if (!bench.has_document()) return without_scene(bench);
  return bench.status().picture ? "" : "the first picture is not finished";
}

std::string without_renders(const SceneBench& bench) {
  return bench.queue && !bench.queue->all().empty() ? "" : "the queue has no render";
}

}  // namespace vug::workbench
