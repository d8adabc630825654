// Expressions to values: parameters, lets and seeded draws here, objects through a Resolver.
#pragma once

#include <vug/scene/arithmetic.h>
#include <vug/scene/document.h>
#include <vug/scene/resolver.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::scene {

/// Names bound for a while (formal parameters of a rule); an inner scope hides an outer one.
struct Scope {
  std::vector<std::pair<std::string, Value>> names;
  const Scope* outer = nullptr;

  const Value* find(const std::string& name) const;
};

/// `-D NAME=EXPR` from a command line.
struct Override {
  std::string name;
  std::string text;
};

/// A parameter with its value for this run; low and high are empty without a range.
struct ParamValue {
  const Param* param = nullptr;
  Value value;
  Value fallback;  ///< The value without overrides.
  Value low;
  Value high;
};

struct EvaluatorOptions {
  std::vector<Override> overrides;
  std::optional<uint64_t> seed;  ///< Instead of the document's.
  double frame = 1;              ///< What `frame` and `keys` stand for.
};

/// Evaluates the expressions of one document. Faults go to the diagnostics and give Value(),
/// which silences everything computed from it. Lets and parameters are evaluated once, when
/// first needed, in any order of the text; a circle among them is a fault. Document, resolver
/// and diagnostics must outlive the evaluator. Not for use by several threads at once.
class Evaluator {
 public:
  Evaluator(const Document& document, Resolver& resolver, Diagnostics& diagnostics,
            EvaluatorOptions options = {});

  /// `key` is the place of this evaluation for seeded choice: the same expression under the same
  /// key draws the same numbers, so rules that are applied again need another key.
  Value eval(const Expr& expr, RandomKey key, const Scope* scope = nullptr);

  /// Arguments of a call expression (none for a name): what a symbol of a grammar is given.
  Arguments arguments(const Expr& call, RandomKey key, const Scope* scope = nullptr);

  /// A repetition count, at least 0: a whole number, or a whole number drawn from a range of
  /// whole ends, both included. Nothing after a fault.
  std::optional<int> count(const Expr& expr, RandomKey key, const Scope* scope = nullptr);

  /// Values of one entry; the key is `key.at(entry.key)`, then the index.
  std::vector<Value> eval(const Entry& entry, RandomKey key, const Scope* scope = nullptr);

  /// The document's seed (0 without) and the key everything in it starts from.
  uint64_t seed() const { return seed_; }
  RandomKey root() const { return RandomKey(seed_); }
  /// Conventional key of a declaration: root, its kind, its name.
  RandomKey key(const Declaration& declaration) const {
    return root().at(declaration.kind).at(declaration.name);
  }

  /// All parameters with their values, checked against their ranges; in order of the text.
  const std::vector<ParamValue>& params();

  /// Evaluates every let and parameter, so that their faults show even where nothing uses them.
  void check_all();

  Diagnostics& diagnostics() { return diagnostics_; }

  /// Tells what a maker found wrong with what it was given. Where it refuses a name that nothing
  /// declares, the nearest declared one becomes the hint.
  void report(const Diagnostics& found, const Arguments& given);

  /// The document's sources and those of the overrides, for `report`.
  std::vector<std::shared_ptr<const Source>> sources() const;

 private:
  /// Where an expression is evaluated.
  struct Context {
    RandomKey key;
    const Scope* scope;
  };
  /// A parameter or let, evaluated when first asked for.
  struct Global {
    const Let* let = nullptr;
    ParamValue* param = nullptr;
    std::optional<Value> value;
    bool moves = false;  ///< It depends on the frame.
    /// How deep calls in calls are that made the value, with names in place of what they stand for;
    /// 0 of a number or a text, which keeps nothing of what it was made of.
    int height = 0;
  };

  void read_overrides();
  void read_seed();
  Value evaluate(const Expr& expr, const Context& context);
  Value name(const Expr& expr, const Context& context);
  Value parts(const Expr& expr, const Context& context);
  Value unary(const Expr& expr, const Context& context);
  Value binary(const Expr& expr, const Context& context);
  Value logical(const Expr& expr, const Context& context);
  Value range(const Expr& expr, const Context& context);
  Value call(const Expr& expr, const Context& context);
  Value choose(const Expr& expr, const Context& context);
  Value pick(const Expr& expr, const Context& context);
  Value keys(const Expr& expr, const Context& context);
  std::optional<bool> truth(const Expr& expr, const Context& context);
  Value global(const std::string& name, Global& global, const SourceLocation& where);
  Value upon(const Global& global, const SourceLocation& where);
  Value param(ParamValue& param, RandomKey key);
  Value like(const Value& fallback, Value given, const std::string& name,
             const SourceLocation& where);
  bool in_range(const ParamValue& param, Value& value, const SourceLocation& where);
  std::string name_hint(const std::string& name) const;
  std::optional<Value> resolved(const Expr& call, const Arguments& given, RandomKey key);
  bool is_known(const Value& value, const Expr& expr);
  FaultSite site(const Expr& expr) const { return {expr.where, diagnostics_}; }

  const Document& document_;
  Resolver& resolver_;
  Diagnostics& diagnostics_;
  EvaluatorOptions options_;
  uint64_t seed_ = 0;
  std::vector<ParamValue> params_;
  std::map<std::string, Global> globals_;
  std::map<std::string, ExprPtr> overrides_;
  std::vector<std::shared_ptr<const Source>> sources_;
  std::vector<std::string> pending_;  ///< Globals being evaluated, to find circles.
  int depth_ = 0;
  int deepest_ = 0;  ///< That depth_ has been, with heights of the names there.
};

}  // namespace vug::scene
