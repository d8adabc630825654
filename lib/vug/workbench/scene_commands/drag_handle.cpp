// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

std::optional<int> axis_of(const std::string& word) {
  if (word == "-") return std::nullopt;
  if (word != "x" && word != "y" && word != "z")
    throw Error(ErrorCode::bad_input, "unknown axis '" + word + "'", {},
                "use x, y or z, or - for the plane across the line of sight");
  return word[0] - 'x';
}

void drag_handle_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.drag_handle(call.words[0], {parse_number(call.words[1]), parse_number(call.words[2])},
                    axis_of(call.word(3, "-")), call.word(4));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(drag_handle) {
  return {.name = "drag_handle",
          .title = "Drag handle",
          .doc =
              "Moves a handle of the statement at the caret by pixels of the picture, or along an "
              "axis x, y or z of its own; drags with the same MERGE count from the first one.",
          .arguments = "NAME DX DY [AXIS] [MERGE]",
          .required = 3,
          .most = 5,
          .unavailable = without_picture,
          .run = drag_handle_in_scene};
}
