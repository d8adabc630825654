// What a scene text says, before anything is made of it: parameters, lets, declarations whose
// kinds this module does not interpret, and grammar blocks. Every part knows its place.
#pragma once

#include <vug/scene/expr.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace vug::scene {

/// A file's text as read; diagnostics quote it.
struct Source {
  std::string file;
  std::string text;
};

/// `param NAME = value in low..high "doc"`; low and high are null without a range.
struct Param {
  std::string name;
  SourceLocation where;
  ExprPtr value;
  ExprPtr low;
  ExprPtr high;
  std::string doc;
};

/// `let NAME = value`
struct Let {
  std::string name;
  SourceLocation where;
  ExprPtr value;
};

/// `key value, value ...` inside braces; also an option of a grammar and a clause of an item.
struct Entry {
  std::string key;
  SourceLocation where;
  std::vector<ExprPtr> values;  ///< At least one; clauses have exactly one.
};

/// `kind name = value` or `kind name on target, target { entries }`. After a fault it may be
/// broken, when its kind and name are all that is sure of it, or incomplete, when some of its
/// entries are lost.
struct Declaration {
  std::string kind;
  SourceLocation kind_where;
  std::string name;
  SourceLocation where;               ///< Of the name.
  ExprPtr value;                      ///< Null in the block form.
  ExprPtr target;                     ///< What follows `on`; null without.
  std::vector<ExprPtr> more_targets;  ///< Behind it, after commas.
  SourceLocation on_where;            ///< Of the word `on`.
  std::vector<Entry> entries;         ///< Empty in the `=` form.
  bool broken = false;
  bool incomplete = false;

  /// The first entry of that key; null without one.
  const Entry* find_entry(const std::string& key) const {
    for (const Entry& entry : entries)
      if (entry.key == key) return &entry;
    return nullptr;
  }
  const Expr& target_at(size_t number) const {
    return number == 0 ? *target : *more_targets.at(number - 1);
  }
};

/// One part of a right-hand side or of the axiom: `op amount shape * count clauses`.
/// Without `op` it uses a symbol of the grammar: `shape` is then a name or a call of one. In a
/// facade it has a shape alone, which may also be a split or an element.
struct Item {
  std::string op;  ///< "+" union, "-" difference, "&" intersection, "~" morph, "" symbol.
  SourceLocation where;
  ExprPtr amount;  ///< Only with "~"; null when not given.
  ExprPtr shape;   ///< Never null.
  ExprPtr count;   ///< Null means once.
  std::vector<Entry> clauses;

  /// The symbol's name (items without `op`).
  const std::string& symbol() const { return shape->text; }
};

struct Formal {
  std::string name;
  SourceLocation where;
};

/// `head(formals) @ weight if guard -> items`; weight and guard may be null.
struct Rule {
  std::string head;
  SourceLocation where;
  std::vector<Formal> formals;
  ExprPtr weight;
  ExprPtr guard;
  std::vector<Item> items;  ///< Empty for `-> nothing`.
};

struct LSystem;  ///< See lsystem_document.h.

/// `grammar name : kind { ... }`. The kind picks the dialect: "shape", "facade", or "lsystem",
/// whose axiom and rules are in `lsystem`.
struct Grammar {
  std::string name;
  SourceLocation where;
  std::string kind = "shape";
  std::vector<Item> axiom;
  SourceLocation axiom_where;
  std::vector<Entry> options;
  std::vector<Rule> rules;
  std::shared_ptr<const LSystem> lsystem;  ///< Null for shapes.
  bool broken = false;                     ///< Something in it is at fault: nothing can be derived.
  std::set<std::string> broken_rules;      ///< Heads of rules that are left out for their faults.
};

/// What faults have hidden of a text. It is there so that nobody blames the rest for it.
struct SkippedNames {
  std::set<std::string> declared;   ///< Names that statements may give which nobody understood.
  std::set<std::string> mentioned;  ///< Names in faulty statements, which may use them.
  std::set<std::string> doubtful;   ///< Parameters and lets of which several meanings are given.
  bool file = false;                ///< A file that could not be included may do anything.

  bool may_declare(const std::string& name) const { return file || declared.count(name); }
  bool may_mention(const std::string& name) const { return file || mentioned.count(name); }
};

struct Document {
  ExprPtr seed;  ///< Null when the text has none.
  std::vector<Param> params;
  std::vector<Let> lets;
  std::vector<Declaration> declarations;
  std::vector<Grammar> grammars;
  SkippedNames skipped;  ///< Empty in a text without faults.
  /// Files in the order they were opened, the scene first.
  std::vector<std::shared_ptr<const Source>> sources;

  const Param* find_param(const std::string& name) const;
  const Let* find_let(const std::string& name) const;
  /// The first declaration of that name, of any kind or of one.
  const Declaration* find(const std::string& name, const std::string& kind = {}) const;
};

/// The whole document in canonical lines; equal documents (places aside) give equal texts.
std::string dump(const Document& document);

}  // namespace vug::scene
