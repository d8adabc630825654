//@ tools/vug/verbs
// STUB: vug new_kind: what it does, in one sentence.
#include "verb.h"

#include <fmt/format.h>

#include <memory>

namespace vug::cli {
namespace {

struct Options {
  std::string scene;
  bool quiet = false;
};

int run(const Options& options) {
  if (!options.quiet) fmt::print("{}\n", options.scene);
  return kDone;
}

}  // namespace

Verb new_kind_verb() {
  return {"new_kind", "STUB: what it does, in one sentence.", [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            app.add_option("scene", options->scene, "STUB: what it reads")->required();
            app.add_flag("--quiet,-q", options->quiet, "say nothing when all is well");
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
