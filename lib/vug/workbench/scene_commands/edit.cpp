// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

#include <cmath>

namespace vug::workbench {
namespace {

size_t byte_count(const std::string& word) {
  const double value = parse_number(word);
  if (value < 0 || value > 1e9 || value != std::floor(value))
    throw Error(ErrorCode::bad_input, "'" + word + "' is not a number of bytes", {}, "such as 12");
  return static_cast<size_t>(value);
}

void edit_scene(SceneBench& bench, const CommandCall& call) {
  bench.edit({byte_count(call.words[0]), byte_count(call.words[1]), call.words[2]},
             call.word(3, "Edit"), call.word(4));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(edit) {
  return {.name = "edit",
          .title = "Edit text",
          .doc =
              "Replaces REMOVED bytes of the text from BEGIN; adjacent changes with the same "
              "MERGE are one step.",
          .arguments = "BEGIN REMOVED TEXT [STEP] [MERGE]",
          .changes = true,
          .required = 3,
          .most = 5,
          .unavailable = without_scene,
          .run = edit_scene};
}
