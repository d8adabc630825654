// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/rescale.h>
#include <vug/workbench/words.h>
#include <cmath>

namespace vug::workbench {
namespace {

void run_scale(FacadeBench& bench, const CommandCall& call) {
  const auto number = [&](size_t i) { return parse_length(call.words[i]); };
  const double now = std::hypot(number(2) - number(0), number(3) - number(1));
  if (!(now > 1e-6))
    throw Error(ErrorCode::bad_input, "the two points are the same", {},
                "click two points of known distance");
  if (!(number(4) > 0)) throw Error(ErrorCode::bad_input, "the length must be above 0");
  bench.change_document(rescaled(bench.document(), number(4) / now), "Set scale");
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(scale) {
  return {
      .name = "scale",
      .title = "Set scale...",
      .doc =
          "Sets the scale: the segment between two points, in the present metres, has this length.",
      .arguments = "X0 Y0 X1 Y1 LENGTH",
      .changes = true,
      .required = 5,
      .most = 5,
      .unavailable = without_document,
      .run = run_scale};
}
