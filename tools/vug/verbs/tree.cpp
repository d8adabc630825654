#include "load.h"

#include <fmt/format.h>
#include <vug/grammar/tree_output.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct Options {
  SceneOptions scene;
  std::string grammar;
  bool json = false;
  bool svg = false;
};

int run(const Options& options) {
  const session::Loaded loaded = options.scene.load();
  bool found = false;
  for (const session::Derivation& derivation : loaded.shot.derivations) {
    if (!options.grammar.empty() && derivation.name != options.grammar) continue;
    if (found && (options.json || options.svg))
      throw Error(ErrorCode::bad_input, "the scene has several grammars", {},
                  "name one with --grammar");
    found = true;
    if (options.json)
      fmt::print("{}\n", grammar::tree_json(derivation.tree));
    else if (options.svg)
      fmt::print("{}", grammar::tree_svg(derivation.tree));
    else
      fmt::print("{}", grammar::tree_text(derivation.tree));
  }
  if (!found) {
    std::vector<std::string> names;
    for (const auto& derivation : loaded.shot.derivations) names.push_back(derivation.name);
    throw Error(ErrorCode::bad_input,
                options.grammar.empty()
                    ? "the scene has no grammar"
                    : fmt::format("the scene has no grammar '{}'", options.grammar),
                {}, suggestion(options.grammar, names));
  }
  return kDone;
}

}  // namespace

Verb tree_verb() {
  return {"tree", "Prints the derivation trees of a scene's grammars.", [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            options->scene.add_to(app);
            app.add_option("--grammar", options->grammar, "only this one");
            auto* json = app.add_flag("--json", options->json, "as JSON");
            app.add_flag("--svg", options->svg, "as a drawing")->excludes(json);
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
