// SPDX-License-Identifier: Apache-2.0
// Conversion of rules into productions of the shared engine: each part of a split becomes an item
// of the successor whose count is the number of its cells. A split inside a split becomes a
// separate symbol with one production.
#include <vug/facade/derive.h>
#include <vug/facade/scope_evaluator.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::facade {
namespace {

class RuleConverter {
 public:
  RuleConverter(const Rules& rules, scene::Evaluator& evaluator, const DeriveOptions& options,
                const PlanOptions* planning = nullptr)
      : rules_(rules),
        evaluator_(evaluator),
        scope_evaluator_(evaluator),
        options_(options),
        planning_(planning) {
    grammar_.name = rules.name;
    grammar_.where = rules.where;
    root_.rect = {0, 0, options.width, options.height};
    root_.key = options.key;
    static const std::vector<std::string> none;
    if (planning) root_.plan = std::make_shared<const Plan>(planning->plan);
    add(rules.axiom, none, "axiom", grammar_.axiom);
    std::map<std::string, int> seen;
    for (size_t i = 0; i < rules.rules.size(); ++i)
      add(rules.rules[i], seen[rules.rules[i].head]++, static_cast<int>(i));
  }

  std::optional<FacadeDerivation> run() {
    Diagnostics found;
    grammar::check(grammar_, found);
    evaluator_.diagnostics().append(found);
    if (found.has_errors()) return std::nullopt;
    try {
      FacadeDerivation out;
      out.derivation = grammar::derive(grammar_, options_.key, options_.limits);
      out.tree = tree_of(out.derivation);
      out.tree.width = options_.width;
      out.tree.height = options_.height;
      if (planning_)
        check_followed(out);
      else
        warn_about_stuck(out);
      return out;
    } catch (const AlreadyReported&) {
      return std::nullopt;
    }
  }

  /// The free numbers requested by the splits of a symbol; valid after run().
  PlannedNode planned(const grammar::Symbol& symbol) const {
    const Scope& scope = scope_of(symbol);
    PlannedNode out{scope.place, scope.plan, {}, scope.mirrored};
    const auto begin = requested_.lower_bound({scope.key.state(), 0});
    for (auto at = begin; at != requested_.end() && at->first.first == scope.key.state(); ++at)
      out.free.insert(out.free.end(), at->second.begin(), at->second.end());
    return out;
  }

 private:
  using Formals = std::vector<std::string>;

  const Scope& scope_of(const grammar::Symbol& symbol) const {
    const auto* scope = std::any_cast<Scope>(&symbol.content.payload);
    return scope ? *scope : root_;
  }

  /// Throws InfeasiblePlan if a rule of the plan was not applied.
  void check_followed(const FacadeDerivation& made) const {
    for (const grammar::Node& node : made.derivation.nodes) {
      const Scope& scope = scope_of(node.symbol);
      if (!node.stuck || !scope.plan || scope.plan->rule < 0) continue;
      const Rule& rule = rules_.rules.at(static_cast<size_t>(scope.plan->rule));
      const bool other = rule.head != node.symbol.name;
      throw InfeasiblePlan(
          other ? Reason::wrong_symbol : Reason::wrong_arguments, "",
          fmt::format("'{}' does not divide {}", to_string(rule), to_string(node.symbol)),
          other ? "" : fmt::format("it takes {} arguments", rule.formals.size()), rule.where);
    }
  }

  /// Adds one warning per symbol to which no rule applied.
  void warn_about_stuck(const FacadeDerivation& made) {
    std::set<std::string> reported;
    for (size_t i = 0; i < made.tree.nodes.size(); ++i) {
      const Node& node = made.tree.nodes[i];
      const std::string& head = made.derivation.nodes[i + 1].symbol.name;
      if (!node.stuck || !reported.insert(head).second) continue;
      SourceLocation where = rules_.where;
      for (const Rule& rule : rules_.rules)
        if (rule.head == head && where == rules_.where) where = rule.where;
      evaluator_.diagnostics().warning(
          where, fmt::format("no rule of '{}' applies to {}", node.text, size_text(node.rect)),
          "add a rule without a guard for all other cases");
    }
  }

  /// Names available in expressions of a rule: its formals, then those of the scope.
  scene::Scope names(const Formals& formals, const grammar::Symbol& symbol) const {
    return names(formals, symbol, scope_of(symbol));
  }
  static scene::Scope names(const Formals& formals, const grammar::Symbol& symbol,
                            const Scope& scope) {
    scene::Scope names;
    for (size_t i = 0; i < formals.size(); ++i)
      names.names.emplace_back(formals[i], symbol.content.params.at(i));
    names.names.emplace_back("width", Number{scope.rect.width, Dimension::length});
    names.names.emplace_back("height", Number{scope.rect.height, Dimension::length});
    names.names.emplace_back("index", scope.index);
    names.names.emplace_back("total", scope.total);
    return names;
  }

  /// Runs the work and adds the scope to its error messages.
  template <class Work>
  auto with_context(const grammar::Symbol& symbol, const SourceLocation& where, const Work& work) {
    Diagnostics& diagnostics = evaluator_.diagnostics();
    const auto context = [&] {
      return scope_of(symbol).rect == root_.rect && symbol.content.params.empty()
                 ? std::string()
                 : ", while dividing " + to_string(symbol);
    };
    try {
      return work();
    } catch (const InfeasiblePlan& error) {
      throw InfeasiblePlan(error.reason(), error.number(), error.what() + context(), error.hint(),
                           where);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) throw;
      if (planning_)
        throw InfeasiblePlan(Reason::does_not_fit, "", error.what() + context(), error.hint(),
                             where);
      diagnostics.error(error.where().known() ? error.where() : where, error.what() + context(),
                        error.hint());
      throw AlreadyReported{};
    }
  }

  bool holds(const Rule& rule, const grammar::RewriteSite& site) {
    if (!rule.guard) return true;
    const Value holds =
        scope_evaluator_.eval(*rule.guard, site.key, names(rule.formals, site.symbol));
    if (const bool* truth = holds.get<bool>()) return *truth;
    return scope_evaluator_.fail(rule.guard->where,
                                 "a guard must be true or false, not " + holds.type_name());
  }

  /// Whether the plan selects the rule for this symbol.
  bool is_planned(const Rule& rule, int number, const grammar::RewriteSite& site) {
    const Scope& scope = scope_of(site.symbol);
    if (!scope.plan || scope.plan->rule != number) return false;
    if (holds(rule, site)) return true;
    throw InfeasiblePlan(Reason::condition, "",
                         fmt::format("the condition of '{}' is false for {}", to_string(rule),
                                     to_string(site.symbol)),
                         "", rule.guard->where);
  }

  void add(const Rule& rule, int number, int in_all) {
    grammar::Production production;
    production.symbol = rule.head;
    production.arity = static_cast<int>(rule.formals.size());
    production.where = rule.where;
    production.name = to_string(rule);
    if (planning_)
      production.guard = [this, &rule, in_all](const grammar::RewriteSite& site) {
        return is_planned(rule, in_all, site);
      };
    else if (rule.guard)
      production.guard = [this, &rule](const grammar::RewriteSite& site) {
        return holds(rule, site);
      };
    if (rule.weight && !planning_)
      production.weight = [this, &rule](const grammar::RewriteSite& site) {
        const Value weight =
            scope_evaluator_.eval(*rule.weight, site.key, names(rule.formals, site.symbol));
        const Number* n = weight.get<Number>();
        if (!n || !(n->value >= 0) || !std::isfinite(n->value))
          scope_evaluator_.fail(
              rule.weight->where,
              "a weight must be a number of at least 0, not " + to_string(weight));
        return n->value;
      };
    const std::string name = fmt::format("{}/{}", rule.head, number);
    add(rule.items, rule.formals, name, production.successor);
    grammar_.productions.push_back(std::move(production));
  }

  /// Adds items; names of free numbers get a prefix for all splits but the first.
  void add(const std::vector<Item>& items, const Formals& formals, const std::string& name,
           std::vector<grammar::SuccessorItem>& parts) {
    int splits = 0;
    for (const Item& item : items) {
      if (item.kind == ItemKind::split && ++splits > 1)
        prefixes_[&item] = fmt::format("{}.", splits);
      add(item, formals, name, parts);
    }
  }

  /// Adds an item that fills the whole scope, or all parts of a split.
  void add(const Item& item, const Formals& formals, const std::string& name,
           std::vector<grammar::SuccessorItem>& parts) {
    if (item.kind != ItemKind::split) {
      parts.push_back(part(item, formals, name, nullptr, 0));
      return;
    }
    for (size_t i = 0; i < item.parts.size(); ++i)
      parts.push_back(part(item.parts[i], formals, fmt::format("{}/{}", name, i), &item, i));
  }

  /// `split` is the split that places the item; null: the item fills the whole scope.
  grammar::SuccessorItem part(const Item& item, const Formals& formals, const std::string& name,
                              const Item* split, size_t number) {
    grammar::SuccessorItem out;
    out.where = item.where;
    out.symbol = item.name;
    out.terminal = item.kind == ItemKind::element || item.kind == ItemKind::value;
    if (item.kind == ItemKind::split) {
      out.symbol = name + '/' + item.name;
      grammar::Production inner;
      inner.symbol = out.symbol;
      inner.where = item.where;
      inner.name = "inside";
      add(item, formals, name, inner.successor);
      grammar_.productions.push_back(std::move(inner));
    }
    const int which = static_cast<int>(number);
    if (split)
      out.count = [this, split, &formals, which](const grammar::RewriteSite& site) {
        int64_t count = 0;
        for (const Cell& cell : evaluated(*split, formals, site.symbol).layout->cells)
          count += cell.part == which;
        return count;
      };
    out.content = [this, &item, split, &formals, which](const grammar::RewriteSite& site) {
      return content(item, split, formals, which, site);
    };
    return out;
  }

  grammar::Content content(const Item& item, const Item* split, const Formals& formals, int which,
                           const grammar::RewriteSite& site) {
    Scope scope = scope_of(site.symbol);
    const Rect whole = scope.rect;
    scope.key = site.key;
    scope.copies.clear();
    scope.given.clear();
    scope.layout.reset();
    scope.split.clear();
    scope.place = {static_cast<int>(split ? split->position : item.position), which, 0, 0};
    Value value;
    if (split) {
      const EvaluatedSplit& all = evaluated(*split, formals, site.symbol);
      place(*all.layout, which, site.repetition, whole, scope);
      scope.layout = all.layout;
      scope.split = split->name;
      value = all.values[item.position];
    }
    if (scope.plan) {
      const auto part = scope.plan->parts.find(scope.place);
      scope.plan = part == scope.plan->parts.end() ? nullptr : part->second;
    }
    // Arguments are evaluated with the names of the part's own cell.
    const scene::Scope known = names(formals, site.symbol, scope);
    grammar::Content out;
    if (item.kind == ItemKind::symbol) {
      for (Argument& argument : evaluator_.arguments(*item.expr, site.key, &known)) {
        if (argument.value.empty()) throw AlreadyReported{};
        out.params.push_back(std::move(argument.value));
      }
    } else if (item.kind == ItemKind::split) {
      out.params = site.symbol.content.params;
    } else {
      scope.element = scope_evaluator_.element(item, value, site.key, known);
    }
    out.text = grammar::to_string(
        {item.name, {item.kind == ItemKind::split ? std::vector<Value>{} : out.params, {}, {}}});
    out.text += fmt::format(" {} at ({}, {})", size_text(scope.rect), metres(scope.rect.x),
                            metres(scope.rect.y));
    if (!scope.copies.empty()) out.text += fmt::format(", {} times", 1 + scope.copies.size());
    out.payload = std::move(scope);
    return out;
  }

  /// Moves the scope to the cell number `repetition` of the part.
  static void place(const Layout& layout, int which, int64_t repetition, const Rect& whole,
                    Scope& scope) {
    for (const Cell& cell : layout.cells) {
      if (cell.part != which || repetition-- > 0) continue;
      const bool turned = scope.mirrored;
      scope.rect = {turned ? whole.right() - cell.rect.right() : whole.x + cell.rect.x,
                    whole.y + cell.rect.y, cell.rect.width, cell.rect.height};
      for (Placement copy : cell.copies) {
        if (turned) copy.x = -copy.x;
        if (copy.mirrored) copy.x += 2 * (turned ? whole.right() : whole.x);
        scope.copies.push_back(copy);
      }
      scope.mirrored = turned != cell.mirrored;
      scope.place.column = cell.column;
      scope.place.row = cell.row;
      scope.given = cell.given;
      scope.depth += cell.depth;
      scope.index = static_cast<double>(cell.index);
      scope.total = static_cast<double>(cell.total);
      return;
    }
  }

  /// The split in the symbol's scope. The last result is cached, because all parts request it in
  /// turn.
  const EvaluatedSplit& evaluated(const Item& split, const Formals& formals,
                                  const grammar::Symbol& symbol) {
    const Scope& scope = scope_of(symbol);
    if (last_ == &split && last_key_ == scope.key.state()) return evaluated_;
    const auto named = prefixes_.find(&split);
    const std::string prefix = named == prefixes_.end() ? "" : named->second;
    evaluated_ = with_context(symbol, split.where, [&] {
      return scope_evaluator_.place(split, scope, names(formals, symbol), planning_, prefix);
    });
    if (planning_) requested_[{scope.key.state(), split.position}] = evaluated_.free;
    last_ = &split;
    last_key_ = scope.key.state();
    return evaluated_;
  }

  const Rules& rules_;
  scene::Evaluator& evaluator_;
  ScopeEvaluator scope_evaluator_;
  DeriveOptions options_;
  const PlanOptions* planning_;
  grammar::Grammar grammar_;
  Scope root_;
  const Item* last_ = nullptr;
  uint64_t last_key_ = 0;
  EvaluatedSplit evaluated_;
  std::map<const Item*, std::string> prefixes_;
  std::map<std::pair<uint64_t, size_t>, std::vector<FreeNumber>>
      requested_;  ///< Indexed by scope and item.
};

}  // namespace

std::optional<FacadeDerivation> derive(const Rules& rules, scene::Evaluator& evaluator,
                                       const DeriveOptions& options) {
  return RuleConverter(rules, evaluator, options).run();
}

std::optional<PlannedDerivation> derive(const Rules& rules, scene::Evaluator& evaluator,
                                        const DeriveOptions& options, const PlanOptions& planning) {
  RuleConverter converter(rules, evaluator, options, &planning);
  std::optional<FacadeDerivation> made = converter.run();
  if (!made) return std::nullopt;
  PlannedDerivation out;
  for (const grammar::Node& node : made->derivation.nodes)
    out.nodes.push_back(converter.planned(node.symbol));
  out.root = out.nodes.front();
  out.nodes.erase(out.nodes.begin());
  out.derived = std::move(*made);
  return out;
}

}  // namespace vug::facade
