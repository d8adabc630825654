// SPDX-License-Identifier: Apache-2.0
#include "verb.h"

#include <fmt/format.h>
#include <vug/loading/catalogue.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct Options {
  std::string what;
  bool json = false;
};

/// Prints the kinds by category, in order of first appearance. `first`: no blank line before the
/// first category.
void print_overview(const std::vector<const KindInfo*>& kinds, bool first) {
  std::string category;
  for (const KindInfo* kind : kinds) {
    if (kind->category != category) {
      category = kind->category;
      fmt::print("{}{}\n", first ? "" : "\n", category);
      first = false;
    }
    fmt::print("  {:<22} {}\n", kind->name, kind->doc);
  }
}

void print_kind(const KindInfo& kind) {
  fmt::print("{} ({}): {}\n", kind.name, kind.category, kind.doc);
  for (const ParamInfo& param : kind.params)
    fmt::print("  {:<14} {}{}\n", param.name, loading::describe(param),
               param.doc.empty() ? "" : "; " + param.doc);
}

int run(const Options& options) {
  const std::vector<const KindInfo*> kinds = loading::find_kinds(options.what);
  if (kinds.empty()) {
    throw Error(ErrorCode::bad_input, fmt::format("unknown kind or category '{}'", options.what),
                {},
                did_you_mean(options.what, loading::kind_words(), "'vug list' lists all of them"));
  }
  if (options.json) {
    fmt::print("{}\n", loading::catalogue_json(kinds).dump(2));
    return kDone;
  }
  std::vector<const KindInfo*> others;
  for (const KindInfo* kind : kinds)
    kind->name == options.what ? print_kind(*kind) : others.push_back(kind);
  print_overview(others, others.size() == kinds.size());
  return kDone;
}

}  // namespace

Verb list_verb() {
  return {"list",
          "Lists the kinds of the scene language, AOVs, image measures and export formats, or "
          "describes "
          "one kind with its parameters.",
          [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            app.add_option("kind", options->what,
                           "Kind (torus), category (primitive) or declaration (material)");
            app.add_flag("--json", options->json, "Machine-readable output");
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
