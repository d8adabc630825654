// SPDX-License-Identifier: Apache-2.0
// Converts scene rules to productions whose callables evaluate expressions of the scene. The leaves
// contain SG+M steps, which sgm::interpret performs.
#include <vug/field/kind.h>
#include <vug/loading/facade_binding.h>
#include <vug/loading/grammar_binding.h>
#include <vug/loading/lsystem_binding.h>
#include <vug/sgm/derive.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

/// Aborts a derivation after an error in the text that has already been reported.
struct AlreadyReported {};

/// Appends the activity to diagnostics from index `first` on: "..., while growing Room(3)".
void add_context(Diagnostics& diagnostics, size_t first, const std::string& doing) {
  Diagnostics out;
  for (size_t i = 0; i < diagnostics.all().size(); ++i) {
    Diagnostic one = diagnostics.all()[i];
    if (i >= first) one.message += ", while " + doing;
    out.add(std::move(one));
  }
  diagnostics = std::move(out);
}

/// The clauses of an item, with the grammar's options as defaults.
struct ItemClauses {
  std::string label = "random";
  std::string piece_label = "random";
  int pieces = 1;
  double amount = 0.5;
  field::Blend blend;
  std::optional<double> overlap;
  std::string reach;
};

/// The local names of a rule that is applied to a symbol: its parameters, then those of `where`.
class RuleScope {
 public:
  RuleScope(const scene::Rule& rule, const grammar::RewriteSite& site)
      : locals_(rule.locals, site.node_key.at("where")) {
    for (size_t i = 0; i < rule.formals.size(); ++i)
      scope_.names.emplace_back(rule.formals[i].name, site.symbol.content.params.at(i));
    scope_.locals = &locals_;
  }
  RuleScope(const RuleScope&) = delete;
  RuleScope& operator=(const RuleScope&) = delete;

  operator const scene::Scope&() const { return scope_; }  // NOLINT

 private:
  scene::Locals locals_;
  scene::Scope scope_;
};

class Binder {
 public:
  Binder(const scene::Grammar& grammar, ReadContext& context)
      : source_(grammar),
        evaluator_(context.evaluator),
        resolver_(context.resolver),
        diagnostics_(context.diagnostics),
        key_(evaluator_.root().at("grammar").at(grammar.name)) {}

  grammar::Grammar bind();
  RandomKey key() const { return key_; }
  /// An option of the grammar block that is a whole number of at least 1; default: `fallback`.
  int64_t limit(const std::string& option, int64_t fallback);
  sgm::Options options();

 private:
  grammar::SuccessorItem part(const scene::Item& item, const scene::Rule& rule);
  grammar::Content step(const scene::Item& item, const scene::Rule& rule,
                        const grammar::RewriteSite& site);
  std::vector<sgm::Piece> pieces(const scene::Item& item, int count, const scene::Scope& scope,
                                 RandomKey key);
  double number(const scene::Expr& expr, RandomKey key, const scene::Scope& scope);
  Value value(const scene::Expr& expr, RandomKey key, const scene::Scope& scope);
  void read_clause(const scene::Entry& clause, RandomKey key, const scene::Scope& scope,
                   ItemClauses& out);
  sgm::Label label(const std::string& name, const SourceLocation& where);
  [[noreturn]] void fail(const SourceLocation& where, const std::string& message,
                         const std::string& hint = {}) {
    diagnostics_.error(where, message, hint);
    throw AlreadyReported{};
  }
  /// Adds the arguments of the symbol to errors of `work`, since the text contains only names.
  template <class Work>
  auto growing(const grammar::RewriteSite& site, const Work& work) {
    const size_t before = diagnostics_.all().size();
    try {
      return work();
    } catch (const AlreadyReported&) {
      if (!site.symbol.content.params.empty())
        add_context(diagnostics_, before, "growing " + grammar::to_string(site.symbol));
      throw;
    }
  }
  const scene::Grammar& source_;
  scene::Evaluator& evaluator_;
  Resolver& resolver_;
  Diagnostics& diagnostics_;
  RandomKey key_;
};

std::vector<std::string> option_names() {
  std::vector<std::string> names;
  for (const ParamInfo& option : grammar_info().params) names.push_back(option.name);
  return names;
}

bool is_limit(const std::string& option) { return option == "steps" || option == "limit"; }

const std::vector<std::string>& clause_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = option_names();
    all.erase(std::remove_if(all.begin(), all.end(), is_limit), all.end());
    return all;
  }();
  return names;
}

Value Binder::value(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) {
  Value result = evaluator_.eval(expr, key, &scope);
  if (result.empty()) throw AlreadyReported{};
  return result;
}

double Binder::number(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) {
  const Value result = value(expr, key, scope);
  const Number* n = result.get<Number>();
  if (!n) fail(expr.where, fmt::format("a number is needed here, not {}", result.type_name()));
  return n->value;
}

sgm::Label Binder::label(const std::string& name, const SourceLocation& where) {
  if (const auto found = sgm::label_from(name)) return *found;
  fail(where, fmt::format("unknown label '{}'", name), suggestion(name, sgm::label_names()));
}

/// The choice in a clause, such as +X or random, even if X or random is declared.
std::optional<std::string> choice(const std::string& key, const scene::Expr& expr) {
  std::string word = expr.text;
  if (expr.kind == scene::ExprKind::unary && expr.operands[0].value->kind == scene::ExprKind::name)
    word += expr.operands[0].value->text;
  else if (expr.kind != scene::ExprKind::name)
    return std::nullopt;
  const bool label = (key == "label" || key == "piece_label") && sgm::label_from(word);
  const bool reach = key == "reach" && (word == "local" || word == "whole");
  return label || reach ? std::optional(word) : std::nullopt;
}

void Binder::read_clause(const scene::Entry& clause, RandomKey key, const scene::Scope& scope,
                         ItemClauses& out) {
  const scene::Expr& expr = *clause.values.at(0);
  const std::optional<std::string> word = choice(clause.key, expr);
  const Value given = word ? Value(Value::Name{*word}) : value(expr, key.at(clause.key), scope);
  const auto* name = given.get<Value::Name>();
  const auto* n = given.get<Number>();
  auto expect = [&](bool fits, const char* what) {
    if (!fits)
      fail(clause.extent, fmt::format("'{}' expects {}, not {}", clause.key, what,
                                      n ? to_string(given) : given.type_name()));
  };
  if (clause.key == "label" || clause.key == "piece_label") {
    expect(name != nullptr, "a direction such as +X, or random");
    label(name->text, clause.extent);
    (clause.key == "label" ? out.label : out.piece_label) = name->text;
  } else if (clause.key == "blend") {
    const auto blend = ValueTraits<field::Blend>::read(given);
    expect(blend.has_value(), "a blend such as smooth(10cm)");
    out.blend = *blend;
  } else if (clause.key == "overlap") {
    expect(n && n->value >= 0 && n->value <= 1, "a share between 0% and 100%");
    out.overlap = n->value;
  } else if (clause.key == "reach") {
    expect(name && (name->text == "local" || name->text == "whole"), "local or whole");
    out.reach = name->text;
  } else if (clause.key == "pieces") {
    expect(n && n->value >= 0 && n->value <= 1000 && n->value == std::floor(n->value),
           "a whole number between 0 and 1000");
    out.pieces = std::max(1, static_cast<int>(n->value));
  } else {
    fail(clause.where, fmt::format("unknown clause '{}'", clause.key),
         suggestion(clause.key, clause_names()));
  }
}

std::vector<sgm::Piece> Binder::pieces(const scene::Item& item, int count,
                                       const scene::Scope& scope, RandomKey key) {
  std::vector<sgm::Piece> out;
  for (int i = 0; i < count; ++i) {
    const Value shape = value(*item.shape, key.at(static_cast<uint64_t>(i)), scope);
    const auto fields = ValueTraits<std::vector<field::Field>>::read(shape);
    if (!fields || fields->empty())
      fail(item.shape->where, fmt::format("a solid is needed here, not {}", shape.type_name()));
    for (const field::Field& f : *fields) out.push_back({f.node()->name(), f});
  }
  return out;
}

grammar::Content Binder::step(const scene::Item& item, const scene::Rule& rule,
                              const grammar::RewriteSite& site) {
  const scene::FrameScope frame(
      resolver_.frames(), fmt::format("rule '{}'", grammar::to_string(site.symbol)), item.where);
  const RuleScope local(rule, site);
  const scene::Scope& scope = local;
  ItemClauses clauses;
  for (const scene::Entry& option : source_.options) {
    const bool is_clause =
        std::find(clause_names().begin(), clause_names().end(), option.key) != clause_names().end();
    if (is_clause) read_clause(option, site.key, scope, clauses);
  }
  for (const scene::Entry& clause : item.clauses) read_clause(clause, site.key, scope, clauses);
  sgm::ProductionStep step;
  step.where = item.where;
  for (const sgm::Operation operation : {sgm::Operation::unite, sgm::Operation::subtract,
                                         sgm::Operation::intersect, sgm::Operation::morph})
    if (sgm::sign_of(operation) == item.op) step.operation = operation;
  step.pieces = pieces(item, clauses.pieces, scope, site.key.at("shape"));
  step.label = label(clauses.label, item.where);
  step.piece_label = label(clauses.piece_label, item.where);
  step.blend = clauses.blend;
  step.overlap = clauses.overlap;
  if (!clauses.reach.empty())
    step.reach = clauses.reach == "local" ? sgm::Reach::local : sgm::Reach::whole;
  if (item.amount) {
    step.amount = number(*item.amount, site.key.at("amount"), scope);
    if (!(step.amount >= 0 && step.amount <= 1))
      fail(item.amount->where, fmt::format("a morph's amount must lie between 0% and 100%, not {}%",
                                           100 * step.amount));
  }
  std::string names;
  for (const sgm::Piece& piece : step.pieces) names += (names.empty() ? "" : " ") + piece.name;
  grammar::Content content;
  content.text = fmt::format(
      "{} {}{}", item.op, item.op == "~" ? fmt::format("{:.0f}% ", 100 * step.amount) : "", names);
  content.payload = std::move(step);
  return content;
}

grammar::SuccessorItem Binder::part(const scene::Item& item, const scene::Rule& rule) {
  grammar::SuccessorItem part;
  part.where = item.where;
  part.terminal = !item.op.empty();
  part.symbol = part.terminal ? item.op : item.symbol();
  if (item.count)
    part.count = [this, &item, &rule](const grammar::RewriteSite& site) {
      return growing(site, [&]() -> int64_t {
        const RuleScope local(rule, site);
        const scene::Scope& scope = local;
        const std::optional<int> count = evaluator_.count(*item.count, site.key, &scope);
        if (!count) throw AlreadyReported{};
        return *count;
      });
    };
  part.content = [this, &item, &rule](const grammar::RewriteSite& site) {
    return growing(site, [&]() -> grammar::Content {
      if (!item.op.empty()) return step(item, rule, site);
      const RuleScope local(rule, site);
      const scene::Scope& scope = local;
      grammar::Content content;
      for (Argument& argument : evaluator_.arguments(*item.shape, site.key, &scope)) {
        if (argument.value.empty()) throw AlreadyReported{};
        content.params.push_back(std::move(argument.value));
      }
      return content;
    });
  };
  return part;
}

grammar::Grammar Binder::bind() {
  static const scene::Rule none;
  grammar::Grammar out;
  out.name = source_.name;
  out.where = source_.where;
  for (const scene::Item& item : source_.axiom) out.axiom.push_back(part(item, none));
  for (const scene::Rule& rule : source_.rules) {
    grammar::Production production;
    production.symbol = rule.head;
    production.arity = static_cast<int>(rule.formals.size());
    production.where = rule.extent;
    if (rule.guard)
      production.guard = [this, &rule](const grammar::RewriteSite& site) {
        return growing(site, [&] {
          const Value holds = value(*rule.guard, site.key, RuleScope(rule, site));
          if (const bool* truth = holds.get<bool>()) return *truth;
          fail(rule.guard->where,
               fmt::format("a guard must be true or false, not {}", holds.type_name()));
        });
      };
    if (rule.weight)
      production.weight = [this, &rule](const grammar::RewriteSite& site) {
        return growing(site, [&] {
          const double weight = number(*rule.weight, site.key, RuleScope(rule, site));
          if (!(weight >= 0) || !std::isfinite(weight))
            fail(rule.weight->where,
                 fmt::format("a weight must be a number of at least 0, not {}", weight));
          return weight;
        });
      };
    for (const scene::Item& item : rule.items) production.successor.push_back(part(item, rule));
    out.productions.push_back(std::move(production));
  }
  return out;
}

int64_t Binder::limit(const std::string& option, int64_t fallback) {
  for (const scene::Entry& entry : source_.options) {
    if (entry.key != option) continue;
    const double n = number(*entry.values.at(0), key_.at(option), {});
    if (!(n >= 1 && n <= 1e9))
      fail(entry.extent, fmt::format("'{}' must be a whole number of at least 1", option));
    return static_cast<int64_t>(n);
  }
  return fallback;
}

sgm::Options Binder::options() {
  const std::vector<std::string> known = option_names();
  for (const scene::Entry& option : source_.options)
    if (std::find(known.begin(), known.end(), option.key) == known.end())
      fail(option.where, fmt::format("a grammar has no option '{}'", option.key),
           suggestion(option.key, known));
  return {};
}

}  // namespace

Value bind_grammar(const scene::Grammar& source, ReadContext& context) {
  if (source.kind == "lsystem") return bind_lsystem(source, context);
  if (source.kind == "facade") return bind_facade(source, context);
  Binder binder(source, context);
  try {
    if (source.broken) {
      binder.options();
      return Value();
    }
    const grammar::Grammar bound = binder.bind();
    Diagnostics own;
    grammar::check(bound, own);
    context.diagnostics.append(own);
    if (own.has_errors()) return Value();
    const sgm::Options options = binder.options();
    const grammar::Limits limits{binder.limit("steps", kMaxProductions),
                                 binder.limit("limit", kMaxSymbols)};
    sgm::DerivationResult result = sgm::derive(bound, binder.key(), options, limits);
    for (const Diagnostic& d : result.diagnostics.all())
      context.diagnostics.warning(d.where.known() ? d.where : source.where, d.message, d.hint);
    if (result.field.bounds().isEmpty())
      context.diagnostics.warning(
          source.where, fmt::format("the grammar '{}' produces nothing", source.name),
          result.counts.total() == 0 ? "no production of a shape was applied; see 'vug tree'" : "");
    context.shot.derivations.push_back(
        {source.name, std::move(result.tree), result.counts.total()});
    Value made = Object{"field", result.field};
    context.resolver.record(made, source.extent);
    return made;
  } catch (const AlreadyReported&) {
    return Value();
  } catch (const Error& error) {
    std::string message = error.what();
    for (const std::string& doing : error.context()) message += ", while " + doing;
    context.diagnostics.error(error.where().known() ? error.where() : source.where, message,
                              error.hint());
    return Value();
  }
}

}  // namespace vug::loading
