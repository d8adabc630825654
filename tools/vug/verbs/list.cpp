// SPDX-License-Identifier: Apache-2.0
#include "verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/example.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace vug::cli {
namespace {

struct ListOptions {
  std::vector<std::string> words;
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
  fmt::print("example:\n");
  std::istringstream lines(loading::example_of(kind));
  for (std::string line; std::getline(lines, line);) fmt::print("  {}\n", line);
}

/// The kinds that the word names, else those that it finds; throws if there are none.
std::vector<const KindInfo*> chosen_kinds(const std::string& word) {
  std::vector<const KindInfo*> kinds = loading::find_kinds(word);
  if (kinds.empty()) kinds = loading::search_kinds(word);
  if (kinds.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("no kind, description or synonym contains '{}'", word), {},
                did_you_mean(word, loading::kind_words(), "'vug list' lists all of them"));
  return kinds;
}

int run_list(const ListOptions& options) {
  const std::string word = fmt::format("{}", fmt::join(options.words, " "));
  const std::vector<const KindInfo*> kinds = chosen_kinds(word);
  if (options.json) {
    fmt::print("{}\n", loading::catalogue_json(kinds).dump(2));
    return kDone;
  }
  std::vector<const KindInfo*> others;
  for (const KindInfo* kind : kinds)
    kind->name == word ? print_kind(*kind) : others.push_back(kind);
  print_overview(others, others.size() == kinds.size());
  return kDone;
}

}  // namespace

Verb list_verb() {
  return {"list",
          "Lists the kinds of the scene language, AOVs, image measures and export formats, "
          "describes one kind with its parameters and an example, or searches them.",
          [](CLI::App& app) {
            auto options = std::make_shared<ListOptions>();
            app.add_option("kind", options->words,
                           "Kind (torus), category (primitive) or declaration (material), or words "
                           "of descriptions and synonyms (stalactite, HDRI, wet rock)");
            app.add_flag("--json", options->json, "Machine-readable output");
            return [options] { return run_list(*options); };
          }};
}

}  // namespace vug::cli
