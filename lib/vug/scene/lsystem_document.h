// SPDX-License-Identifier: Apache-2.0
// The syntax tree of an L-system's block: words, productions and tables.
#pragma once

#include <vug/scene/document.h>

#include <optional>

namespace vug::scene {

/// `Name(expression, ...)` or one of the turtle's signs, including brackets; "?P" is a query.
struct Module {
  std::string name;
  SourceLocation where;  ///< With its arguments.
  std::vector<ExprPtr> arguments;
};
using ModuleString = std::vector<Module>;

/// `Name(formal, ...)` on a left-hand side; in a right context also "[" and "]".
struct Pattern {
  std::string name;
  SourceLocation where;
  std::vector<Formal> formals;
};

/// `left < head > right @ weight if guard after age -> word where name = value, ...`; omitted parts
/// are empty or null.
struct Production {
  SourceLocation extent;
  std::vector<Pattern> left;
  Pattern head;
  std::vector<Pattern> right;
  ExprPtr weight;
  ExprPtr guard;
  ExprPtr after;      ///< The age at which the module is replaced.
  ModuleString word;  ///< Empty for `-> nothing`.
  std::vector<Let> locals;
};

/// `table NAME { productions }`, applied in the steps scheduled for the table.
struct ProductionTable {
  std::string name;
  SourceLocation where;
  SourceLocation extent;
  std::vector<Production> productions;
};

/// `decompose { ... }` or `interpret { ... }`.
struct ProductionStage {
  SourceLocation where;   ///< Location of the keyword; unknown without such a block.
  SourceLocation extent;  ///< With the block in braces.
  ExprPtr depth;          ///< May be null.
  std::vector<Production> productions;
};

/// `table * count` of a schedule; `count` may be null (once).
struct ScheduleTurn {
  std::string table;
  SourceLocation where;
  ExprPtr count;
};

struct LSystem {
  ModuleString axiom;
  std::vector<Production> productions;  ///< Outside of tables: applied in every step.
  std::vector<ProductionTable> tables;
  std::vector<ScheduleTurn> schedule;
  ProductionStage decompose;
  ProductionStage interpret;
  std::vector<Pattern> ignore;    ///< Names that contexts skip.
  std::vector<Pattern> consider;  ///< If not empty, contexts skip all other names.
  std::vector<Pattern> ages;      ///< Names whose first parameter is an age.
};

/// Calls visit(production) for all productions, including those of tables and stages.
template <class Visit>
void for_each_production(const LSystem& system, const Visit& visit) {
  for (const Production& one : system.productions) visit(one);
  for (const ProductionTable& table : system.tables)
    for (const Production& one : table.productions) visit(one);
  for (const ProductionStage* stage : {&system.decompose, &system.interpret})
    for (const Production& one : stage->productions) visit(one);
}

/// The block in canonical lines; a part of dump(Document).
std::string dump(const LSystem& system);

/// True for the turtle's commands: signs, F, f and G. They may have any number of parameters,
/// regardless of rules.
bool is_turtle_name(const std::string& name);

}  // namespace vug::scene
