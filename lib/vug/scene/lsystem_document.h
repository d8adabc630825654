// What the block of an L-system says: words, productions and tables, still as text says them.
#pragma once

#include <vug/scene/document.h>

#include <optional>

namespace vug::scene {

/// `Name(expression, ...)` or one of the turtle's signs, brackets among them; "?P" is a query.
struct Module {
  std::string name;
  SourceLocation where;
  std::vector<ExprPtr> arguments;
};
using ModuleString = std::vector<Module>;

/// `Name(formal, ...)` on a left side; in a right context also "[" and "]".
struct Pattern {
  std::string name;
  SourceLocation where;
  std::vector<Formal> formals;
};

/// `left < head > right @ weight if guard after age -> word`; what is not written is empty or null.
struct Production {
  std::vector<Pattern> left;
  Pattern head;
  std::vector<Pattern> right;
  ExprPtr weight;
  ExprPtr guard;
  ExprPtr after;      ///< The age at which a module that ages is replaced.
  ModuleString word;  ///< Empty for `-> nothing`.
};

/// `table NAME { productions }`, which apply in the steps of its turns.
struct ProductionTable {
  std::string name;
  SourceLocation where;
  std::vector<Production> productions;
};

/// `decompose { ... }` or `interpret { ... }`.
struct ProductionStage {
  SourceLocation where;  ///< Of the word; unknown without such a block.
  ExprPtr depth;         ///< Null when not given.
  std::vector<Production> productions;
};

/// `table * count` of a schedule; `count` is null for once.
struct ScheduleTurn {
  std::string table;
  SourceLocation where;
  ExprPtr count;
};

struct LSystem {
  ModuleString axiom;
  std::vector<Production> productions;  ///< Outside of tables: they apply in every step.
  std::vector<ProductionTable> tables;
  std::vector<ScheduleTurn> schedule;
  ProductionStage decompose;
  ProductionStage interpret;
  std::vector<Pattern> ignore;    ///< Names that contexts look past.
  std::vector<Pattern> consider;  ///< If not empty, contexts look past all other names.
  std::vector<Pattern> ages;      ///< Names whose first parameter is an age.
};

/// Calls visit(production) for each one, those of tables and stages among them.
template <class Visit>
void for_each_production(const LSystem& system, const Visit& visit) {
  for (const Production& one : system.productions) visit(one);
  for (const ProductionTable& table : system.tables)
    for (const Production& one : table.productions) visit(one);
  for (const ProductionStage* stage : {&system.decompose, &system.interpret})
    for (const Production& one : stage->productions) visit(one);
}

/// In canonical lines: a part of dump(Document).
std::string dump(const LSystem& system);

/// True for the turtle's own names: signs, F, f and G. They may bear any number of parameters
/// whatever rules say of them.
bool is_turtle_name(const std::string& name);

}  // namespace vug::scene
