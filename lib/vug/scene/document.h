// SPDX-License-Identifier: Apache-2.0
// The syntax tree of a scene text: parameters, lets, functions, declarations, whose kinds are not
// interpreted here, and grammar blocks. In every element, `extent` is the range of its whole text,
// and `where` that of its name.
#pragma once

#include <vug/scene/expr.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vug::scene {

/// A file's text, quoted by diagnostics.
struct Source {
  std::string file;
  std::string text;
  SourceLocation included_from = {};  ///< The path in the first `include` of it; unknown: none.
};

/// `param NAME = value in low..high "doc"`. Without a range, low and high are null.
struct Param {
  std::string name;
  SourceLocation where;
  SourceLocation extent;
  ExprPtr value;
  ExprPtr low;
  ExprPtr high;
  std::string doc;
  ExprPtr given = nullptr;  ///< The value that the include of a module gives it; null: none.
};

/// `let NAME = value`
struct Let {
  std::string name;
  SourceLocation where;
  SourceLocation extent;
  ExprPtr value;
};

/// `def NAME(formals) "doc" = body where name = value, ...`
struct Def {
  std::string name;
  SourceLocation where;
  SourceLocation extent;
  std::vector<Formal> formals;
  std::string doc;
  ExprPtr body;
  std::vector<Let> locals;
  /// The number of calls and loop iterations that one call makes as far as the text determines it.
  double work = 1;
  bool broken = false;  ///< Has a reported fault: calls have no value.
};

/// `key value, value ...` inside braces; also an option of a grammar and a clause of an item.
struct Entry {
  std::string key;
  SourceLocation where;
  SourceLocation extent;
  std::vector<ExprPtr> values;  ///< At least one; clauses have exactly one.
};

/// `kind name = value` or `kind name on target, target { entries }`. After a syntax error it may be
/// `broken` (only kind and name are valid) or `incomplete` (some entries are missing).
struct Declaration {
  std::string kind;
  SourceLocation kind_where;
  std::string name;
  SourceLocation where;               ///< Location of the name.
  SourceLocation extent;              ///< If incomplete, as far as it was parsed.
  ExprPtr value;                      ///< Null in the block form.
  ExprPtr target;                     ///< The expression after `on`; null without `on`.
  std::vector<ExprPtr> more_targets;  ///< Further targets after commas.
  SourceLocation on_where;            ///< Location of the word `on`.
  /// `NAME[i in LIST]`: a comprehension of the bound names, a declaration for each element; or
  /// null.
  ExprPtr loop;
  std::vector<Entry> entries;  ///< Empty in the `=` form.
  bool broken = false;
  bool incomplete = false;

  /// The first entry with that key, or null.
  const Entry* find_entry(const std::string& key) const {
    for (const Entry& entry : entries)
      if (entry.key == key) return &entry;
    return nullptr;
  }
  const Expr& target_at(size_t number) const {
    return number == 0 ? *target : *more_targets.at(number - 1);
  }
};

/// The name of the declaration of an element: "lamp" for "lamp[2]", other names unchanged.
std::string name_without_index(const std::string& element);

/// One item of a right-hand side or of the axiom: `op amount shape * count clauses`. Without `op`
/// it refers to a symbol of the grammar: `shape` is a name or a call. In a facade it consists of a
/// shape only, which may also be a split or an element.
struct Item {
  std::string op;        ///< "+" union, "-" difference, "&" intersection, "~" morph, "" symbol.
  SourceLocation where;  ///< The whole item: it has no name.
  ExprPtr amount;        ///< Only with "~"; may be null.
  ExprPtr shape;         ///< Never null.
  ExprPtr count;         ///< Null: once.
  std::vector<Entry> clauses;

  /// The symbol's name (items without `op`).
  const std::string& symbol() const { return shape->text; }
};

/// `head(formals) @ weight if guard -> items where name = value, ...`; weight and guard may be
/// null.
struct Rule {
  std::string head;
  SourceLocation where;
  SourceLocation extent;
  std::vector<Formal> formals;
  ExprPtr weight;
  ExprPtr guard;
  std::vector<Item> items;  ///< Empty for `-> nothing`.
  std::vector<Let> locals;
};

struct LSystem;  ///< See lsystem_document.h.

/// The option of a shape grammar that names the network which it dresses. Such a grammar needs no
/// axiom.
inline constexpr const char* kDressOption = "dress";

/// `grammar name : kind { ... }`. The kind selects the dialect: "shape", "facade", or "lsystem",
/// whose axiom and rules are in `lsystem`.
struct Grammar {
  std::string name;
  SourceLocation where;
  SourceLocation extent;
  std::string kind = "shape";
  std::vector<Item> axiom;
  SourceLocation axiom_where;
  std::vector<Entry> options;
  std::vector<Rule> rules;
  std::shared_ptr<const LSystem> lsystem;  ///< Null for other kinds.
  bool broken = false;                     ///< Contains errors: nothing can be derived.
  std::set<std::string> broken_rules;      ///< Heads of rules that were omitted because of errors.
};

/// `include "path" as name { key value ... }`
struct Include {
  std::string path;
  SourceLocation where;  ///< Location of the path.
  std::string name;      ///< Empty without `as`: the file's names are those of the including file.
  SourceLocation name_where;
  std::vector<Entry> entries;  ///< Values of the file's parameters.
};

/// A file whose names have a prefix.
struct ImportedModule {
  std::string name;  ///< With the prefix of the including file.
  SourceLocation where;
};

/// Names in text that was skipped after syntax errors. They suppress errors in the rest of the text
/// that would only follow from the skipped part.
struct SkippedNames {
  std::set<std::string> declared;   ///< Names that skipped statements may declare.
  std::set<std::string> mentioned;  ///< Names that skipped statements may use.
  std::set<std::string> doubtful;   ///< Names with several declarations.
  bool file = false;                ///< An included file is missing; it may contain anything.

  bool may_declare(const std::string& name) const { return file || declared.count(name); }
  bool may_mention(const std::string& name) const { return file || mentioned.count(name); }
};

struct Document {
  ExprPtr seed;  ///< Null if the text has no seed.
  std::vector<Param> params;
  std::vector<Let> lets;
  std::vector<Def> defs;
  std::vector<Declaration> declarations;
  std::vector<Grammar> grammars;
  std::vector<ImportedModule> modules;
  SkippedNames skipped;  ///< Empty in a text without faults.
  /// Files in the order in which they were opened, the scene first.
  std::vector<std::shared_ptr<const Source>> sources;

  const Param* find_param(const std::string& name) const;
  const Let* find_let(const std::string& name) const;
  const ImportedModule* find_module(const std::string& name) const;
  /// The first declaration with that name, of the given kind or (empty) of any kind. `lamp[2]` is
  /// the name of an element of a loop.
  const Declaration* find(const std::string& name, const std::string& kind = {}) const;
};

/// The whole document in canonical form; documents that are equal except for locations have equal
/// texts.
std::string dump(const Document& document);

}  // namespace vug::scene
