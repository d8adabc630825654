// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void run_zoom(FacadeBench& bench, const CommandCall& call) {
  const double factor = parse_number(call.words[0]);
  if (!(factor > 0)) throw Error(ErrorCode::bad_input, "the zoom factor must be above 0");
  bench.view().canvas =
      bench.view().canvas.zoomed(factor, parse_number(call.words[1]), parse_number(call.words[2]));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(zoom) {
  return {.name = "zoom",
          .title = "Zoom",
          .doc = "Magnifies the view around a point of the canvas, in pixels.",
          .arguments = "FACTOR X Y",
          .required = 3,
          .most = 3,
          .unavailable = without_document,
          .run = run_zoom};
}
