// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

#include <algorithm>

namespace vug::workbench {
namespace {

int one_based(const std::string& word) {
  return static_cast<int>(std::clamp(parse_number(word), 1.0, 1e9));
}

void go_to_scene_line(SceneBench& bench, const CommandCall& call) {
  bench.select(language::range_at(bench.file().string(),
                                  {one_based(call.words[0]), one_based(call.word(1, "1"))}));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(go) {
  return {.name = "go",
          .title = "Go to line",
          .doc = "Moves the caret to a line and a column of the text.",
          .arguments = "LINE [COLUMN]",
          .required = 1,
          .most = 2,
          .unavailable = without_scene,
          .run = go_to_scene_line};
}
