// SPDX-License-Identifier: Apache-2.0
// The names that a document declares, and the places that refer to them.
#pragma once

#include <vug/language/position.h>
#include <vug/scene/document.h>
#include <vug/scene/lexer.h>

#include <string>
#include <vector>

namespace vug::language {

enum class SymbolKind {
  param,
  let,
  function,
  declaration,  ///< A light, a camera, a volume, ...: Symbol::keyword.
  grammar,
  module,     ///< A file that is included `as NAME`.
  rule,       ///< The head of rules of a grammar, or a module of an L-system.
  table,      ///< A table of an L-system.
  parameter,  ///< A parameter of a function or a rule.
  local,      ///< After `where`.
  variable    ///< A variable of a loop.
};

struct Symbol {
  SymbolKind kind = SymbolKind::let;
  std::string name;       ///< Without the prefix of its module.
  std::string full_name;  ///< With it; equal to `name` for local names.
  std::string keyword;    ///< The first word of its statement; empty for local names.
  SourceLocation where;   ///< The name in its declaration, which identifies the symbol.
  SourceLocation extent;  ///< Its declaration.
  SourceLocation scope;   ///< The range in which a local name is visible; unknown: everywhere.
  std::string doc;        ///< As written in the text; may be empty.
  int outer = -1;         ///< Index of the symbol whose declaration contains this one, or -1.
};

/// An occurrence of a symbol's name.
struct Reference {
  SourceLocation where;
  int symbol = 0;         ///< Index in SymbolTable::symbols.
  bool declares = false;  ///< True at the name in a declaration, and at each head of a rule.
  /// False for a word in a statement with a syntax error that only looks like the name.
  bool certain = true;
};

struct SymbolTable {
  std::vector<Symbol> symbols;  ///< In the order of the declarations, by file.
  std::vector<Reference> references;

  /// The reference at a position of a file; null if there is none.
  const Reference* at(const std::string& file, const Position& position) const;
  const Symbol& of(const Reference& reference) const {
    return symbols.at(static_cast<size_t>(reference.symbol));
  }
  /// The global symbols and the local ones that are visible at the position.
  std::vector<const Symbol*> visible_at(const std::string& file, const Position& position) const;
};

/// The symbols of a document and all certain references to them.
SymbolTable collect_symbols(const scene::Document& document);

/// Adds the uncertain references of a text with syntax errors: names among its tokens that are no
/// certain reference and look like one of a global symbol.
void add_uncertain_references(const std::vector<scene::Token>& tokens, const std::string& file,
                              SymbolTable& table);

/// The word of a symbol's kind for people: "param", "light", "rule", "loop variable", ...
std::string description(const Symbol& symbol);

}  // namespace vug::language
