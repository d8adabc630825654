// SPDX-License-Identifier: Apache-2.0
// The rules of a facade's grammar as a table: symbols, their splits and parts. The table is static;
// sizes are only known during a derivation.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/facade/element.h>
#include <vug/facade/split.h>
#include <vug/scene/document.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::facade {

enum class ItemKind {
  symbol,   ///< A symbol with rules.
  split,    ///< A split with parts.
  element,  ///< An element of a kind.
  value     ///< A name that may be an element or a number: a let, a parameter, a formal.
};

/// One item of a right-hand side, or one part of a split.
struct Item {
  ItemKind kind = ItemKind::symbol;
  std::string name;  ///< Name of the symbol or of the kind.
  SourceLocation where;
  scene::ExprPtr expr;      ///< Never null: the name or the call.
  size_t position = 0;      ///< Index among the rule's items or among the split's operands.
  std::vector<Item> parts;  ///< Parts of a split in the order of its operands.
  const SplitKind* split = nullptr;
  const ElementKind* element = nullptr;
};

/// `head(formals) @ weight if guard -> items`; each item fills the head's whole scope.
struct Rule {
  std::string head;
  std::vector<std::string> formals;
  SourceLocation where;
  scene::ExprPtr weight;  ///< Null: 1.
  scene::ExprPtr guard;   ///< Null: always.
  std::vector<Item> items;
};

struct Rules {
  std::string name;
  SourceLocation where;
  std::vector<Item> axiom;
  std::vector<Rule> rules;

  /// The alphabet of the grammar: the heads in the order of the text, then the kinds of elements in
  /// the rules.
  std::vector<std::string> symbols() const;
};

/// The rule with names only, e.g. "Facade -> rows(FacadeRow, PartFacade)".
std::string to_string(const Rule& rule);

/// The rules of a grammar of kind facade. Adds diagnostics for unknown names, symbols with a wrong
/// number of arguments, and items that are not valid in a facade.
Rules read_rules(const scene::Document& document, const scene::Grammar& grammar,
                 Diagnostics& diagnostics);

/// The rules of the only grammar of kind facade in a file. Throws Error(bad_input) with the first
/// error.
Rules load_rules(const std::filesystem::path& file);

}  // namespace vug::facade
