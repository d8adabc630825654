// SPDX-License-Identifier: Apache-2.0
// Values of expressions in the rules of shape grammars, during their derivation.
#pragma once

#include <vug/grammar/grammar.h>
#include <vug/loading/reader.h>

namespace vug::loading {

/// Aborts a derivation after an error in the text that has already been reported.
struct AlreadyReported {};

/// The local names of a rule that is applied to a symbol: its parameters, then those of `where`.
class RuleScope {
 public:
  /// `order`: for each parameter of the rule the index of its value in the symbol; null: the same.
  RuleScope(const scene::Rule& rule, const grammar::RewriteSite& site,
            const std::vector<size_t>* order = nullptr);
  RuleScope(const RuleScope&) = delete;
  RuleScope& operator=(const RuleScope&) = delete;

  operator const scene::Scope&() const { return scope_; }  // NOLINT

 private:
  scene::Locals locals_;
  scene::Scope scope_;
};

/// Evaluates expressions of a grammar; after an error, which it reports, it throws AlreadyReported.
class RuleValues {
 public:
  explicit RuleValues(ReadContext& context)
      : evaluator_(context.evaluator), diagnostics_(context.diagnostics) {}

  Value value(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) const;
  double number(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) const;
  [[noreturn]] void fail(const SourceLocation& where, const std::string& message,
                         const std::string& hint = {}) const;

  /// Adds the arguments of the symbol to errors of `work`, since the text contains only names.
  template <class Work>
  auto growing(const grammar::RewriteSite& site, const Work& work) const {
    const size_t before = diagnostics_.all().size();
    try {
      return work();
    } catch (const AlreadyReported&) {
      if (!site.symbol.content.params.empty())
        add_context(before, "growing " + grammar::to_string(site.symbol));
      throw;
    }
  }

 private:
  /// Appends the activity to diagnostics from index `first` on: "..., while growing Room(3)".
  void add_context(size_t first, const std::string& doing) const;

  scene::Evaluator& evaluator_;
  Diagnostics& diagnostics_;
};

}  // namespace vug::loading
