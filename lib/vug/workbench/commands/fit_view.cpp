// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void run_fit_view(FacadeBench& bench, const CommandCall& call) {
  const modeller::Canvas& facade = bench.state().canvas();
  bench.view().canvas = CanvasView::whole(facade.width, facade.height, parse_number(call.words[0]),
                                          parse_number(call.words[1]));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(fit_view) {
  return {.name = "fit_view",
          .title = "Show whole facade",
          .doc = "Shows the whole facade in a canvas of this size in pixels.",
          .arguments = "WIDTH HEIGHT",
          .required = 2,
          .most = 2,
          .unavailable = without_document,
          .run = run_fit_view};
}
