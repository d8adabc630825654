// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/facade/tree_output.h>
#include <vug/grammar/tree_output.h>
#include <vug/shot/lsystem_plan.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct TreeOptions {
  SceneOptions scene;
  std::string grammar;
  bool json = false, svg = false, theta = false, elements = false, elevation = false;
  std::string picture;

  /// Whether the output is one document, which can show only one grammar.
  bool single() const { return json || svg || elements || elevation || !picture.empty(); }
  /// Whether the output exists for facades only.
  bool facade() const { return theta || elements || elevation || !picture.empty(); }
};

std::string hint_for(const shot::Shot& shot, const TreeOptions& options,
                     const std::vector<std::string>& names) {
  for (const shot::LSystemPtr& each : shot.lsystems)
    if (options.grammar.empty() || each->name == options.grammar)
      return fmt::format("'{}' is an L-system: 'vug derive' prints its word", each->name);
  return suggestion(options.grammar, names);
}

/// The selected derivations: at least one, and exactly one if the output is one document.
std::vector<const shot::Derivation*> select_derivations(const shot::Shot& shot,
                                                        const TreeOptions& options) {
  std::vector<const shot::Derivation*> found;
  std::vector<std::string> names;
  for (const shot::Derivation& derivation : shot.derivations) {
    if (options.facade() && !derivation.facade) continue;
    names.push_back(derivation.name);
    if (options.grammar.empty() || derivation.name == options.grammar) found.push_back(&derivation);
  }
  const std::string what = options.facade() ? "grammar of kind facade" : "grammar";
  if (found.empty())
    throw Error(ErrorCode::bad_input,
                options.grammar.empty()
                    ? fmt::format("the scene has no {}", what)
                    : fmt::format("the scene has no {} '{}'", what, options.grammar),
                {}, hint_for(shot, options, names));
  if (found.size() > 1 && options.single())
    throw Error(ErrorCode::bad_input,
                fmt::format("the scene has several grammars: {}", fmt::join(names, ", ")), {},
                "name one with --grammar");
  return found;
}

std::string text_of(const shot::Derivation& derivation, const TreeOptions& options) {
  if (options.theta) return facade::theta(*derivation.facade) + "\n";
  if (options.elements) return facade::elements_csv(*derivation.facade);
  if (options.elevation || !options.picture.empty())
    return facade::elevation_svg(*derivation.facade, {.picture = options.picture});
  if (options.svg) return grammar::tree_svg(derivation.tree);
  if (!options.json) return grammar::tree_text(derivation.tree);
  return derivation.facade ? facade::tree_json(*derivation.facade)
                           : grammar::tree_json(derivation.tree);
}

int run_tree(const TreeOptions& options) {
  const loading::Loaded loaded = options.scene.load();
  for (const shot::Derivation* derivation : select_derivations(loaded.shot, options))
    fmt::print("{}", text_of(*derivation, options));
  return kDone;
}

}  // namespace

Verb tree_verb() {
  return {
      "tree", "Prints the derivation trees of a scene's grammars.", [](CLI::App& app) {
        auto options = std::make_shared<TreeOptions>();
        options->scene.add_to(app);
        app.add_option("--grammar", options->grammar, "Name of the grammar; default all");
        auto* form = app.add_option_group("form", "Output format; default text");
        form->add_flag("--json", options->json, "JSON");
        form->add_flag("--svg", options->svg, "Drawing of the tree as SVG");
        form->add_flag("--theta", options->theta, "Facade in the notation of Ripperda and Brenner");
        form->add_flag("--elements", options->elements, "Table of a facade's elements, in metres");
        form->add_flag("--elevation", options->elevation,
                       "Drawing of a facade's rectangles as SVG");
        form->add_option("--overlay", options->picture,
                         "Drawing of a facade's rectangles over this picture");
        form->require_option(0, 1);
        return [options] { return run_tree(*options); };
      }};
}

}  // namespace vug::cli
