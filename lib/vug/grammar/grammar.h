// SPDX-License-Identifier: Apache-2.0
// Symbols, productions and grammars, shared by all grammar dialects. The engine is independent of
// geometry; a symbol's payload is opaque to it and is read only by callables.
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

/// The content of an occurrence of a symbol, in addition to its name.
struct Content {
  std::vector<Value> params;  ///< Input of guards, weights, counts and successors.
  std::any payload;           ///< E.g. a rectangle or an operation on solids; opaque to the engine.
  std::string text;           ///< Label in printed trees; empty: the name and the parameters.
};

/// One occurrence of a symbol.
struct Symbol {
  std::string name;
  Content content;
};

/// E.g. "Room(0.5, 2)", or the content's text.
std::string to_string(const Symbol& symbol);

/// The argument of a production's callables. `key` is unique to the call, so drawing from it does
/// not affect other calls. Callables may run on several threads at once.
struct RewriteSite {        // NOLINT(cppcoreguidelines-pro-type-member-init): key has no default
  const Symbol& symbol;     ///< The occurrence that is being rewritten.
  RandomKey key;            ///< Source of this call's random numbers.
  RandomKey node_key;       ///< That of the occurrence, the same in all calls for it.
  int depth = 0;            ///< The occurrence's distance from the tree's root.
  int64_t repetition = 0;   ///< For content: the 0-based index of the repetition.
  int64_t repetitions = 1;  ///< For content: the number of repetitions.
};

/// One symbol of a production's right side, with its repetition count.
struct SuccessorItem {
  std::string symbol;
  bool terminal = false;  ///< Never rewritten, even if productions exist.
  SourceLocation where;
  std::function<int64_t(const RewriteSite&)> count;  ///< Null: once. Below 0 is an Error.
  std::function<Content(const RewriteSite&)>
      content;  ///< Null: nothing. Called for each repetition.
};

/// symbol : guard @weight -> successor. Applies if name and arity match and the guard holds.
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

/// The production's name, or a text such as "Room -> + Room".
std::string to_string(const Production& production);

struct Grammar {
  std::string name = "grammar";  ///< Symbol of the tree's root, the parent of the axiom.
  std::vector<SuccessorItem> axiom;
  std::vector<Production> productions;
  SourceLocation where;
};

/// Reports an empty axiom and symbols that are neither terminal nor rewritten (with the nearest
/// name) as errors, and unreachable productions as warnings.
void check(const Grammar& grammar, Diagnostics& diagnostics);

}  // namespace vug::grammar
