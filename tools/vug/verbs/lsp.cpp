// SPDX-License-Identifier: Apache-2.0
#include "lsp/stdio_loop.h"
#include "verb.h"

#include <fmt/format.h>
#include <vug/language/kinds.h>
#include <vug/language/words.h>
#include <vug/loading/data_folders.h>
#include <vug/scene/functions.h>
#include <vug/scene/units.h>
#include <nlohmann/json.hpp>

#include <iostream>
#include <set>

namespace vug::cli {
namespace {

struct LspOptions {
  int debounce = 200;
  bool stdio = false;
  bool words = false;
};

std::vector<std::string> texts_of(const std::vector<language::LanguageWord>& words) {
  std::vector<std::string> names;
  for (const language::LanguageWord& word : words) names.emplace_back(word.name);
  return names;
}

/// The words of the language by their use, for the highlighting rules of editors.
nlohmann::ordered_json words_json() {
  std::set<std::string> calls;
  for (const language::CallableKind& kind : language::callable_kinds())
    calls.insert(kind.info->name);
  for (const scene::Function& function : scene::functions()) calls.insert(function.name);
  std::vector<std::string> constants;
  for (const language::LanguageWord& word : language::value_words()) {
    const bool called = std::string_view(word.use).find('(') != std::string_view::npos;
    if (called)
      calls.insert(word.name);
    else
      constants.emplace_back(word.name);
  }
  return {{"statements", texts_of(language::statement_words())},
          {"declarations", language::declaration_words()},
          {"inner", texts_of(language::inner_words())},
          {"constants", constants},
          {"calls", calls},
          {"units", scene::unit_names()}};
}

int run_lsp(const LspOptions& options) {
  if (options.words) {
    fmt::print("{}\n", words_json().dump(2));
    return kDone;
  }
  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);  // else the thread that reads would flush the output of the other one
  lsp::LoopOptions loop;
  loop.workspace.include_folders = loading::data_folders();
  loop.debounce = std::chrono::milliseconds(options.debounce);
  return lsp::run_server(std::cin, std::cout, loop) == 0 ? kDone : kAnswerNo;
}

}  // namespace

Verb lsp_verb() {
  return {"lsp", "Answers the requests of an editor: the language server, on standard input.",
          [](CLI::App& app) {
            auto options = std::make_shared<LspOptions>();
            app.add_option("--debounce", options->debounce,
                           "Milliseconds without a message before diagnostics; default 200")
                ->check(CLI::Range(0, 60000));
            app.add_flag("--stdio", options->stdio,
                         "No effect: the only transport, which some editors request");
            app.add_flag("--words", options->words,
                         "Print the words of the language as JSON, for highlighting rules");
            return [options] { return run_lsp(*options); };
          }};
}

}  // namespace vug::cli
