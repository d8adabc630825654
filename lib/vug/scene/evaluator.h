// SPDX-License-Identifier: Apache-2.0
// The evaluator of a document: parameters with their ranges and `-D` overrides, lets and the seed
// (evaluator.cpp), the limits of values that are composed through names and functions; objects are
// provided by a Resolver.
#pragma once

#include <vug/scene/arithmetic.h>
#include <vug/scene/document.h>
#include <vug/scene/resolver.h>
#include <vug/scene/scope.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::scene {

/// The parameters of a function as those of a kind, without types.
KindInfo info_of(const Def& def);

/// `-D NAME=EXPR` of a command line.
struct Override {
  std::string name;
  std::string text;
};

/// A parameter with its value in this run. Without a range, low and high are empty.
struct ParamValue {
  const Param* param = nullptr;
  Value value;
  Value fallback;  ///< The value without overrides.
  Value low;
  Value high;
};

/// `variant NAME { PARAM value ... }` with the values of its parameters; empty after an error.
struct VariantValues {
  const Declaration* variant = nullptr;
  std::vector<std::pair<std::string, Value>> values;
};

struct EvaluatorOptions {
  std::vector<Override> overrides;
  std::optional<uint64_t> seed;  ///< Overrides the document's seed.
  double frame = 1;              ///< The frame at which `frame` and `keys` are evaluated.
  std::string variant = {};      ///< Name of a variant; `overrides` take precedence over it.
};

/// Evaluates the expressions of one document. Errors are added to the diagnostics and give Value(),
/// which suppresses errors of everything computed from it. Lets and parameters are evaluated once,
/// on first use, in any order of the text; a cyclic definition is an error. Document, resolver and
/// diagnostics must outlive the evaluator. Not thread-safe.
class Evaluator {
 public:
  Evaluator(const Document& document, Resolver& resolver, Diagnostics& diagnostics,
            EvaluatorOptions options = {});

  /// `key` determines the random choices: the same expression with the same key draws the same
  /// numbers, so each application of a rule needs its own key.
  Value eval(const Expr& expr, RandomKey key, const Scope* scope = nullptr);
  /// For an expression whose value must be an object of a type such as "light": a name that several
  /// kinds share, such as `sphere`, then means the kind of this type.
  Value eval_as(std::string_view type, const Expr& expr, RandomKey key);

  /// The arguments of a call expression (none for a name), e.g. of a grammar's symbol.
  Arguments arguments(const Expr& call, RandomKey key, const Scope* scope = nullptr);

  /// A repetition count, at least 0: a whole number, or one drawn from a range between whole
  /// numbers, both included. Returns nothing after an error.
  std::optional<int> count(const Expr& expr, RandomKey key, const Scope* scope = nullptr);

  /// The values of one entry, evaluated with `key.at(entry.key)` followed by the index.
  std::vector<Value> eval(const Entry& entry, RandomKey key, const Scope* scope = nullptr);

  /// The document's seed (default 0) and the root key of all random choices.
  uint64_t seed() const { return seed_; }
  RandomKey root() const { return RandomKey(seed_); }
  /// Conventional key of a declaration: root, its kind, its name.
  RandomKey key(const Declaration& declaration) const {
    return root().at(declaration.kind).at(declaration.name);
  }

  /// All parameters with their values, checked against their ranges; in order of the text.
  const std::vector<ParamValue>& params();

  /// All variants with their values, checked like overrides; in order of the text.
  std::vector<VariantValues> variants();

  /// Evaluates every let and parameter to report their errors even if nothing uses them.
  void check_all();

  /// Reports unknown names and functions in the functions of the scene file that have not been
  /// called, after everything else has been evaluated.
  void check_uncalled();

  Diagnostics& diagnostics() { return *diagnostics_; }

  /// The function of the text with that name; null if there is none.
  const Def* find_def(const std::string& name) const;

  /// The evaluation of a declaration: for its lifetime, expressions that are evaluated without a
  /// scope see the variables of its loop only, and its work is counted separately.
  class DeclarationScope {
   public:
    explicit DeclarationScope(Evaluator& evaluator)
        : evaluator_(evaluator),
          variables_(std::exchange(evaluator.variables_, nullptr)),
          planned_(std::exchange(evaluator.planned_, 1)),
          done_(std::exchange(evaluator.done_, 0)) {}
    ~DeclarationScope() {
      evaluator_.variables_ = variables_;
      evaluator_.planned_ = planned_;
      evaluator_.done_ = done_;
    }
    DeclarationScope(const DeclarationScope&) = delete;
    DeclarationScope& operator=(const DeclarationScope&) = delete;

    /// The next expressions are those of one of `count` elements of the loop. All elements together
    /// have the limit of a single expression.
    void begin_element(const Scope& variables, size_t count) {
      evaluator_.variables_ = &variables;
      evaluator_.planned_ = static_cast<double>(count);
    }

   private:
    Evaluator& evaluator_;
    const Scope* variables_;
    double planned_, done_;
  };
  /// The variables of the loop of the declaration that is evaluated; null: none.
  const Scope* variables() const { return variables_; }

  /// Adds the diagnostics of a kind about its arguments. If an argument is an undeclared name, the
  /// nearest declared name becomes the hint.
  void report(const Diagnostics& found, const Arguments& given);

  /// The sources of the document and of the overrides, for scene::report.
  std::vector<std::shared_ptr<const Source>> sources() const;

 private:
  /// The context in which an expression is evaluated.
  struct Context {
    RandomKey key;
    const Scope* scope;
    std::string_view expected;  ///< The type of object that the value must have; empty: any.
  };
  /// A parameter or let, evaluated on first use.
  struct Global {
    const Let* let = nullptr;
    ParamValue* param = nullptr;
    std::optional<Value> value;
    bool animated = false;              ///< The value depends on the frame.
    std::vector<DeclarationName> uses;  ///< The declarations that its value uses.
    /// Nesting depth of the calls that made the value, including those of referenced names; 0 for a
    /// number or a text, which does not refer to its inputs.
    int height = 0;
  };

  struct DefEntry {
    const Def* def = nullptr;
    KindInfo info;
  };
  struct LoopResult;

  void read_overrides();
  void read_variant();
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
  Value call_def(const DefEntry& entry, const Expr& expr, size_t first, const Context& context);
  Value call_member(const Expr& expr, const Context& context);
  bool is_module_call(const Expr& expr) const;
  bool bind(const DefEntry& entry, const Expr& expr, std::vector<Binding>& given, RandomKey key,
            Scope& scope);
  Binding measured(const std::string& name, const Expr& expr, const Context& context);
  std::optional<Value> find_local(const Expr& expr, const Scope* scope);
  Value local(const Let& let, const Scope& scope, const SourceLocation& where);
  Value comprehension(const Expr& expr, const Context& context);
  bool run_loop(const Expr& expr, size_t clause, const Context& context, LoopResult& result);
  Binding elements(const Expr& expr, const Context& context);
  std::optional<List> whole_numbers(const Expr& range, const Context& context);
  bool bind(const Operand& clause, const Value& element, int height, Scope& scope);
  bool sort(const std::vector<Value>& keys, std::vector<size_t>& order, const Expr& by);
  Value element(const Expr& expr, const Context& context);
  Value checked_size(List list, const Expr& expr);
  bool admit(double work, const char* what, const SourceLocation& where);
  bool spend_on(const Value& value, const SourceLocation& where);
  bool is_cyclic(const std::vector<std::string>& pending, const std::string& name,
                 const SourceLocation& where);
  std::optional<Value> declaration(const std::string& full, const SourceLocation& where,
                                   std::string_view expected);
  std::optional<bool> truth(const Expr& expr, const Context& context);
  Value global(const std::string& name, Global& global, const SourceLocation& where);
  Value use(const Value& value, int height, const SourceLocation& where);
  Value param(ParamValue& param, RandomKey key);
  /// The value of an override, checked for its type and the range.
  Value replacement(const ParamValue& param, const Expr& expr, const Context& context);
  Value variant_value(const Declaration& variant, const Entry& entry);
  Value match_type(const Value& fallback, Value given, const std::string& what,
                   const SourceLocation& where);
  bool in_range(const ParamValue& param, Value& value, const SourceLocation& where);
  std::string name_hint(const std::string& name) const;
  void report_unknown_function(const Expr& call);
  std::string hint_for_module_function(const std::string& name) const;
  std::optional<Value> resolved(const Expr& call, const Arguments& given, RandomKey key,
                                std::string_view expected);
  bool is_known(const Value& value, const Expr& expr);
  void begin_expression();
  FaultSite site(const Expr& expr) const { return {expr.where, *diagnostics_}; }
  const Scope* scope_or_default(const Scope* scope) const { return scope ? scope : variables_; }

  const Document& document_;
  Resolver& resolver_;
  Diagnostics* diagnostics_;  ///< Never null.
  EvaluatorOptions options_;
  uint64_t seed_ = 0;
  std::vector<ParamValue> params_;
  std::map<std::string, Global> globals_;
  std::map<std::string, DefEntry> defs_;
  std::set<std::string> called_;            ///< Functions of the text.
  std::set<std::string> reported_in_defs_;  ///< Faults in functions: each is reported once.
  const Scope* variables_ = nullptr;        ///< See DeclarationScope.
  std::map<std::string, ExprPtr> overrides_;
  std::vector<std::shared_ptr<const Source>> sources_;
  std::vector<std::string> pending_;  ///< Globals being evaluated, to detect cycles.
  double planned_ = 1;                ///< Product of the lengths of the loops that are running.
  double done_ = 0;  ///< Calls of functions and loop iterations of this expression so far.
  int depth_ = 0;
  int deepest_ = 0;  ///< Maximum of depth_ including the heights of the names used there.
};

}  // namespace vug::scene
