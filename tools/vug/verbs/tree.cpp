#include "load.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
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

/// The trees that are asked for: at least one, and only one where one document is printed.
std::vector<const grammar::Tree*> chosen(const session::Shot& shot, const Options& options) {
  std::vector<const grammar::Tree*> trees;
  std::vector<std::string> names;
  for (const session::Derivation& derivation : shot.derivations) {
    names.push_back(derivation.name);
    if (options.grammar.empty() || derivation.name == options.grammar)
      trees.push_back(&derivation.tree);
  }
  if (trees.empty())
    throw Error(ErrorCode::bad_input,
                options.grammar.empty()
                    ? "the scene has no grammar"
                    : fmt::format("the scene has no grammar '{}'", options.grammar),
                {}, suggestion(options.grammar, names));
  if (trees.size() > 1 && (options.json || options.svg))
    throw Error(ErrorCode::bad_input,
                fmt::format("the scene has several grammars: {}", fmt::join(names, ", ")), {},
                "name one with --grammar");
  return trees;
}

int run(const Options& options) {
  const session::Loaded loaded = options.scene.load();
  for (const grammar::Tree* tree : chosen(loaded.shot, options))
    fmt::print("{}", options.json  ? grammar::tree_json(*tree)
                     : options.svg ? grammar::tree_svg(*tree)
                                   : grammar::tree_text(*tree));
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
