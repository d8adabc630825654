// An L-system made ready to rewrite words: immutable, shared, without any text to look things up
// in.
#pragma once

#include <vug/base/error.h>
#include <vug/lsystem/program.h>
#include <vug/lsystem/word.h>

#include <map>
#include <memory>
#include <optional>

namespace vug::lsystem {

/// One module of a context; "[" opens and "]" closes a branch that a right context enters.
struct ContextModule {
  enum class Kind : uint8_t { module, open, close };
  Kind kind = Kind::module;
  SymbolId symbol = 0;
};

/// left < head > right: guard @weight after age -> symbols with values. Formals are numbered
/// through the left context, the head and the right context, in the order of the text.
struct Production {
  std::string text;  ///< The head as written, for messages.
  SourceLocation where;
  SymbolId head = 0;
  std::vector<ContextModule> left;
  std::vector<ContextModule> right;
  Program guard;                  ///< Empty: always.
  Program weight;                 ///< Empty: the first that fits is taken, without a draw.
  Program after;                  ///< Empty: the module does not age.
  std::vector<SymbolId> symbols;  ///< Of the successor.
  std::vector<uint32_t> ends;     ///< Where each one's values end.
  Program values;                 ///< Leaves all values of the successor on the stack.
  bool simple = false;            ///< Each instruction of `values` makes one value.
  bool in_place = false;          ///< `values` needs no more room than its results.
  std::vector<uint32_t> ages;     ///< Which values are ages.
  uint32_t blocks = 0;  ///< Of random numbers for `values` and `after`; see RandomNumbers.

  bool has_context() const { return !left.empty() || !right.empty(); }
  size_t value_count() const { return ends.empty() ? 0 : ends.back(); }
};

/// How a symbol's production is found among `first` up to, not including, `end` of a book's rules.
struct RuleSelection {
  enum class How : uint8_t {
    never,       ///< There is none.
    always,      ///< The first one.
    weighted,    ///< Weights that are constants and nothing else: RuleBook::cumulative_weights.
    sequential,  ///< Each in turn.
  };
  uint32_t first = 0, end = 0;
  uint32_t blocks = 0;  ///< Of random numbers that it takes; see RandomNumbers.
  How how = How::never;
};

/// The productions of each symbol, as indices, in the order in which they are tried.
struct RuleBook {
  std::vector<RuleSelection> symbols;  ///< By symbol.
  std::vector<uint16_t> rules;
  std::vector<double>
      cumulative_weights;  ///< By rule: the sum of the weights of its symbol's rules up to it.
  bool contexts = false;   ///< Some of them look around.

  bool empty() const { return rules.empty(); }
  bool has(SymbolId symbol) const { return symbols[symbol].how != RuleSelection::How::never; }
};

/// Decomposition or interpretation: rules that are applied until none fits.
struct Stage {
  RuleBook book;
  std::optional<int> depth;  ///< At most so often; else to the end, which has to come.
};

struct System;
using SystemPtr = std::shared_ptr<const System>;

/// Another system that a module stands for.
struct SubSystem {
  SystemPtr system;
  std::vector<SymbolId> symbols;  ///< What its symbols are in the outer alphabet.
};

struct System {
  std::string name;
  SourceLocation where;
  Alphabet alphabet;
  Production axiom;  ///< Without a head.
  std::vector<Production> productions;
  std::vector<RuleBook> books;     ///< Of each table; one without tables.
  std::vector<uint16_t> schedule;  ///< The book of each step, over and over; never empty.
  Stage decompose;
  Stage interpret;
  std::vector<bool> ignored;  ///< By symbol: contexts look past it.
  std::vector<bool> ages;     ///< By symbol: the first parameter is an age.
  std::vector<bool> query;    ///< By symbol: an Environment sets its parameters.
  std::map<SymbolId, SubSystem> subsystems;
  std::optional<SymbolId> open, close, cut;  ///< [ ] %
  bool random = false;                       ///< Something is drawn: modules need keys.
  bool timed = false;                        ///< Modules age; `time` counts, not `steps`.
  bool has_queries = false;                  ///< There are queries.
  int steps = 1;
  double time = 0;             ///< Of timed systems.
  int64_t limit = 10'000'000;  ///< Modules that a word may have.
  uint64_t key = 0;            ///< Where random numbers come from; see RandomKey.

  /// The end of the name of every query.
  static bool is_query(const std::string& symbol) { return symbol.size() > 1 && symbol[0] == '?'; }
};

}  // namespace vug::lsystem
