// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/delivery/recipe.h>

namespace vug::cli {
namespace {

struct RecipeOptions {
  std::string file, output;
};

int run_recipe(const RecipeOptions& options) {
  require_no_scene(options.file);
  const delivery::Recipe recipe = delivery::read_recipe(options.file);
  if (options.output.empty()) {
    fmt::print("{}", recipe.scene);
  } else {
    require_outputs({options.output}, {options.file});
    write_text(options.output, recipe.scene);
  }
  for (const std::string& argument : recipe.arguments)
    fmt::print(stderr, "build it with: {}\n", argument);
  if (!recipe.version.empty() && recipe.version != VUG_VERSION)
    fmt::print(stderr, "made by vug {}, this is {}\n", recipe.version, VUG_VERSION);
  return kDone;
}

}  // namespace

Verb recipe_verb() {
  return {"recipe", "Prints the scene text from which a file was built and can be rebuilt.",
          [](CLI::App& app) {
            auto options = std::make_shared<RecipeOptions>();
            app.add_option(
                   "file", options->file,
                   "A .vdb, .glb, .usda, .usdc, .ply, .obj, picture, partial render or checkpoint")
                ->required();
            app.add_option("-o,--output", options->output, "Output file; default standard output");
            return [options] { return run_recipe(*options); };
          }};
}

}  // namespace vug::cli
