// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>
#include <algorithm>

namespace vug::workbench {
namespace {

void run_opacity(FacadeBench& bench, const CommandCall& call) {
  bench.view().opacity = std::clamp(parse_number(call.words[0]), 0.0, 1.0);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(opacity) {
  return {.name = "opacity",
          .title = "Opacity of photo",
          .doc = "Sets the opacity of the photo, from 0 to 1.",
          .arguments = "SHARE",
          .required = 1,
          .most = 1,
          .unavailable = without_photo,
          .run = run_opacity};
}
