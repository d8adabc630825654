// SPDX-License-Identifier: Apache-2.0
// A compiled L-system: immutable, shared, independent of its text.
#pragma once

#include <vug/base/error.h>
#include <vug/lsystem/program.h>
#include <vug/lsystem/word.h>

#include <map>
#include <memory>
#include <optional>

namespace vug::lsystem {

/// One module of a context; "[" and "]" delimit a branch that a right context enters.
struct ContextModule {
  enum class Kind : uint8_t { module, open, close };
  Kind kind = Kind::module;
  SymbolId symbol = 0;
};

/// left < head > right: guard @weight after age -> symbols with values. Formals are numbered
/// consecutively over the left context, the head and the right context, in the order of the text.
struct Production {
  std::string text;  ///< The head as written, for messages.
  SourceLocation where;
  SymbolId head = 0;
  std::vector<ContextModule> left;
  std::vector<ContextModule> right;
  Program guard;                  ///< Empty: always.
  Program weight;                 ///< Empty: the first matching rule is taken, without a draw.
  Program after;                  ///< Empty: the module does not age.
  std::vector<SymbolId> symbols;  ///< Symbols of the successor.
  std::vector<uint32_t> ends;     ///< End of each symbol's values.
  Program values;                 ///< Computes all values of the successor.
  bool simple = false;            ///< Each instruction of `values` computes one value.
  bool in_place = false;          ///< The stack of `values` never exceeds its results.
  std::vector<uint32_t> ages;     ///< Indices of the values that are ages.
  uint32_t blocks = 0;            ///< Blocks of random numbers for `values` and `after`.

  bool has_context() const { return !left.empty() || !right.empty(); }
  size_t value_count() const { return ends.empty() ? 0 : ends.back(); }
};

/// How a symbol's production is selected among the rules [first, end) of a book.
struct RuleSelection {
  enum class How : uint8_t {
    never,       ///< The symbol has no rules.
    always,      ///< The first rule.
    weighted,    ///< Rules with constant weights only: RuleBook::cumulative_weights.
    sequential,  ///< The rules are tried in order.
  };
  uint32_t first = 0, end = 0;
  uint32_t blocks = 0;  ///< Blocks of random numbers for the selection; see RandomNumbers.
  How how = How::never;
};

/// The productions of each symbol, as indices, in the order in which they are tried.
struct RuleBook {
  std::vector<RuleSelection> symbols;  ///< By symbol.
  std::vector<uint16_t> rules;
  /// By rule: the sum of its symbol's weights up to and including the rule.
  std::vector<double> cumulative_weights;
  bool contexts = false;  ///< Some rules have a context.

  bool empty() const { return rules.empty(); }
  bool has(SymbolId symbol) const { return symbols[symbol].how != RuleSelection::How::never; }
};

/// Decomposition or interpretation: rules that are applied until none matches.
struct Stage {
  RuleBook book;
  std::optional<int> depth;  ///< Maximum number of rounds; empty: until no rule applies.
};

struct System;
using SystemPtr = std::shared_ptr<const System>;

/// Another system that a module refers to.
struct SubSystem {
  SystemPtr system;
  std::vector<SymbolId> symbols;  ///< Maps its symbols to the outer alphabet.
};

struct System {
  std::string name;
  SourceLocation where;
  Alphabet alphabet;
  Production axiom;  ///< Without a head.
  std::vector<Production> productions;
  std::vector<RuleBook> books;     ///< One per table; a single one without tables.
  std::vector<uint16_t> schedule;  ///< The book of each step, repeated cyclically; never empty.
  Stage decompose;
  Stage interpret;
  std::vector<bool> ignored;  ///< By symbol: contexts skip it.
  std::vector<bool> ages;     ///< By symbol: the first parameter is an age.
  std::vector<bool> query;    ///< By symbol: an Environment sets its parameters.
  std::map<SymbolId, SubSystem> subsystems;
  std::optional<SymbolId> open, close, cut;  ///< [ ] %
  bool random = false;                       ///< Random numbers are used: modules need keys.
  bool timed = false;                        ///< Modules age; `time` replaces `steps`.
  bool has_queries = false;                  ///< The system has queries.
  int steps = 1;
  double time = 0;             ///< Derivation time of timed systems.
  int64_t limit = 10'000'000;  ///< Maximum number of modules of a word.
  uint64_t key = 0;            ///< Key of the random numbers; see RandomKey.

  /// Whether the symbol's name denotes a query.
  static bool is_query(const std::string& symbol) { return symbol.size() > 1 && symbol[0] == '?'; }
};

}  // namespace vug::lsystem
