//@ tools/vug/verbs
// SPDX-License-Identifier: Apache-2.0
// vug new_kind. STUB: its purpose, in one sentence.
#include "verb.h"

#include <fmt/format.h>

#include <memory>

namespace vug::cli {
namespace {

struct NewKindOptions {
  std::string scene;
  bool quiet = false;
};

int run_new_kind(const NewKindOptions& options) {
  if (!options.quiet) fmt::print("{}\n", options.scene);
  return kDone;
}

}  // namespace

Verb new_kind_verb() {
  return {"new_kind", "STUB: its purpose, in one sentence.", [](CLI::App& app) {
            auto options = std::make_shared<NewKindOptions>();
            app.add_option("scene", options->scene, "STUB: its input")->required();
            app.add_flag("--quiet,-q", options->quiet, "No output if there is nothing to report");
            return [options] { return run_new_kind(*options); };
          }};
}

}  // namespace vug::cli
