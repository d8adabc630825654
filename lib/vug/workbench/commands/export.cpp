// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/export_facade.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_export(FacadeBench& bench, const CommandCall& call) {
  export_facade(bench, call.words[0], call.words[1]);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(export) {
  return {.name = "export",
          .title = "Export...",
          .doc = "Writes a file: svg, png, json, theta, scene (a grammar), carve (a rock scene).",
          .arguments = "KIND FILE",
          .keys = "Ctrl+E",
          .required = 2,
          .most = 2,
          .unavailable = without_document,
          .run = run_export};
}
