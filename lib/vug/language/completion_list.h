// SPDX-License-Identifier: Apache-2.0
// Inside the module: collects the completions of a place.
#pragma once

#include <vug/language/completion.h>
#include <vug/language/expectation.h>

#include <set>

namespace vug::language {

class CompletionList {
 public:
  CompletionList(const Analysis& analysis, const Position& position, const Context& context)
      : analysis_(analysis), position_(position), context_(context) {}

  void add_statements();
  void add_keys();
  void add_values();
  void add_symbols();
  void add_members();
  void add_units();
  void add_words(const std::vector<LanguageWord>& words, const std::set<std::string>& chosen,
                 int rank);
  void add(Completion item);

  std::vector<Completion> take() { return std::move(items_); }

 private:
  void add_arguments();
  void add_choices(const Expectation& expectation);
  void add_kinds(const std::string& type, int rank);
  void add_functions(int rank);
  void add_names(const std::string& type, int rank);
  void add_call(const CallMeaning& meaning, const char* detail, int rank);
  void add_symbol(const Symbol& symbol, const std::string& name, int rank);

  const Analysis& analysis_;
  const Position& position_;
  const Context& context_;
  std::vector<Completion> items_;
  std::set<std::pair<std::string, CompletionKind>> known_;
};

/// The call of a kind with fields for its required parameters.
std::string call_snippet(const KindInfo& info, size_t skipped);

}  // namespace vug::language
