// Symbols, productions and grammars: the part that all of this toolkit's systems share. The
// engine knows no geometry; what a symbol carries is its payload, which only callables read.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/rng.h>
#include <vug/base/value.h>

#include <any>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vug::grammar {

/// What an occurrence of a symbol carries beside its name.
struct Content {
  std::vector<Value> params;  ///< What guards, weights, counts and successors compute from.
  std::any payload;           ///< E.g. a rectangle, or a step on solids; opaque to the engine.
  std::string text;           ///< How trees show it; empty: the name and the parameters.
};

/// One occurrence of a symbol.
struct Symbol {
  std::string name;
  Content content;
};

/// "Room(0.5, 2)" or the content's own text.
std::string to_string(const Symbol& symbol);

/// What the callables of a production are given. `key` belongs to that one call alone, so drawing
/// from it changes nothing else. Callables may run on several threads at once.
struct RewriteSite {        // NOLINT(cppcoreguidelines-pro-type-member-init): key has no default
  const Symbol& symbol;     ///< The occurrence that is being rewritten.
  RandomKey key;            ///< Source of this call's random numbers.
  int depth = 0;            ///< The occurrence's distance from the tree's root.
  int64_t repetition = 0;   ///< For a part's content: which of the repetitions, from 0.
  int64_t repetitions = 1;  ///< For a part's content: how many there are.
};

/// One symbol of a production's right side, repeated.
struct SuccessorItem {
  std::string symbol;
  bool terminal = false;  ///< Never rewritten, whatever productions there are.
  SourceLocation where;
  std::function<int64_t(const RewriteSite&)> count;  ///< Null: once. Below 0 is an Error.
  std::function<Content(const RewriteSite&)>
      content;  ///< Null: nothing. Called for each repetition.
};

/// symbol : guard @weight -> parts. Applies where name and arity fit and the guard holds.
struct Production {
  std::string symbol;
  int arity = -1;    ///< Number of parameters the symbol must have; -1: any.
  std::string name;  ///< For traces and messages; empty: symbol and right side.
  SourceLocation where;
  std::function<bool(const RewriteSite&)> guard;  ///< Null: always.
  std::function<double(const RewriteSite&)>
      weight;                            ///< Null: 1. Finite and >= 0, otherwise an Error.
  std::vector<SuccessorItem> successor;  ///< Empty: the symbol vanishes.
};

/// The production's name, or "Room -> + Room" made of its parts.
std::string to_string(const Production& production);

struct Grammar {
  std::string name = "grammar";  ///< Symbol of the tree's root, which the axiom hangs on.
  std::vector<SuccessorItem> axiom;
  std::vector<Production> productions;
  SourceLocation where;
};

/// Finds what no derivation can mean: an empty axiom, symbols that are neither terminal nor
/// rewritten (with the nearest name), and, as warnings, productions that nothing reaches.
void check(const Grammar& grammar, Diagnostics& diagnostics);

}  // namespace vug::grammar
