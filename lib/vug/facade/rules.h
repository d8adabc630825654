// The rules of a facade's grammar as a table: which symbol becomes which split of which parts. It
// shows without deriving anything; what the sizes are only shows while deriving.
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
  symbol,   ///< A symbol that has rules.
  split,    ///< A split of parts.
  element,  ///< An element of a kind.
  value     ///< A name that may be an element or a number: a let, a parameter, a formal.
};

/// One item of a right side, or one part of a split.
struct Item {
  ItemKind kind = ItemKind::symbol;
  std::string name;  ///< Of the symbol, or of the kind.
  SourceLocation where;
  scene::ExprPtr expr;      ///< Never null: the name or the call.
  size_t position = 0;      ///< Among the rule's items; of a part, among the split's operands.
  std::vector<Item> parts;  ///< Of a split, in the order of its operands.
  const SplitKind* split = nullptr;
  const ElementKind* element = nullptr;
};

/// `head(formals) @ weight if guard -> items`, all of which stand in the head's whole scope.
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

  /// Heads, in the order of the text, then the kinds of elements that stand in the rules: the
  /// alphabet of the grammar.
  std::vector<std::string> symbols() const;
};

/// "Facade -> rows(FacadeRow, PartFacade)": names only.
std::string to_string(const Rule& rule);

/// The rules of a grammar of kind facade. Diagnostics for names that are nothing, symbols with
/// another number of arguments than their rules take, and items that a facade does not have.
Rules read_rules(const scene::Document& document, const scene::Grammar& grammar,
                 Diagnostics& diagnostics);

/// The rules of the only grammar of kind facade in a file. Error(bad_input) with the first fault.
Rules load_rules(const std::filesystem::path& file);

}  // namespace vug::facade
