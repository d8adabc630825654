// Rules become productions of the shared engine: each part of a split is a part of the production,
// its count the number of places that the split gives it. A split inside a split is a symbol of its
// own with one production.
#include <vug/facade/derive.h>
#include <vug/facade/scope.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vug::facade {
namespace {

/// Thrown out of a derivation whose text is at fault; the diagnostics already say why.
struct Faulty {};

std::string metres(double value) { return fmt::format("{:.4g}", value); }

std::string size_text(const Rect& r) {
  return fmt::format("{} x {} m", metres(r.width), metres(r.height));
}

/// What a split comes to in one scope: its places, and its arguments by operand.
struct Placed {
  std::shared_ptr<const Layout> layout;
  std::vector<Value> values;
};

class Divider {
 public:
  Divider(const Rules& rules, scene::Evaluator& evaluator, const DeriveOptions& options)
      : rules_(rules), evaluator_(evaluator), options_(options) {
    grammar_.name = rules.name;
    grammar_.where = rules.where;
    root_.rect = {0, 0, options.width, options.height};
    root_.key = options.key;
    static const std::vector<std::string> none;
    for (const Item& item : rules.axiom) add(item, none, "axiom", grammar_.axiom);
    std::map<std::string, int> seen;
    for (const Rule& rule : rules.rules) add(rule, seen[rule.head]++);
  }

  std::optional<Derived> run() {
    Diagnostics found;
    grammar::check(grammar_, found);
    evaluator_.diagnostics().append(found);
    if (found.has_errors()) return std::nullopt;
    try {
      Derived out;
      out.derivation = grammar::derive(grammar_, options_.key, options_.limits);
      out.tree = tree_of(out.derivation);
      out.tree.width = options_.width;
      out.tree.height = options_.height;
      warn_of_stuck(out);
      return out;
    } catch (const Faulty&) {
      return std::nullopt;
    }
  }

 private:
  using Formals = std::vector<std::string>;

  const Scope& scope_of(const grammar::Symbol& symbol) const {
    const auto* scope = std::any_cast<Scope>(&symbol.content.payload);
    return scope ? *scope : root_;
  }

  /// One warning for each symbol that was left over.
  void warn_of_stuck(const Derived& made) {
    std::set<std::string> told;
    for (size_t i = 0; i < made.tree.nodes.size(); ++i) {
      const Node& node = made.tree.nodes[i];
      const std::string& head = made.derivation.nodes[i + 1].symbol.name;
      if (!node.stuck || !told.insert(head).second) continue;
      SourceLocation where = rules_.where;
      for (const Rule& rule : rules_.rules)
        if (rule.head == head && where == rules_.where) where = rule.where;
      evaluator_.diagnostics().warning(
          where, fmt::format("no rule of '{}' applies to {}", node.text, size_text(node.rect)),
          "a rule without a guard would be the one for all other cases");
    }
  }

  /// Names that expressions of a rule see: its formals, then those of the scope.
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

  /// Runs the work; what it reports says for which scope.
  template <class Work>
  auto doing(const grammar::Symbol& symbol, const SourceLocation& where, const Work& work) {
    Diagnostics& diagnostics = evaluator_.diagnostics();
    const auto context = [&] {
      return scope_of(symbol).rect == root_.rect && symbol.content.params.empty()
                 ? std::string()
                 : ", while dividing " + to_string(symbol);
    };
    try {
      return work();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) throw;
      diagnostics.error(error.where().known() ? error.where() : where, error.what() + context(),
                        error.hint());
      throw Faulty{};
    }
  }

  Value eval(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) {
    Value value = evaluator_.eval(expr, key, &scope);
    if (value.empty()) throw Faulty{};
    return value;
  }

  void add(const Rule& rule, int number) {
    grammar::Production production;
    production.symbol = rule.head;
    production.arity = static_cast<int>(rule.formals.size());
    production.where = rule.where;
    production.name = to_string(rule);
    if (rule.guard)
      production.guard = [this, &rule](const grammar::Site& site) {
        const Value holds = eval(*rule.guard, site.key, names(rule.formals, site.symbol));
        if (const bool* truth = holds.get<bool>()) return *truth;
        return fail(rule.guard->where, "a guard is true or false, not " + holds.type_name());
      };
    if (rule.weight)
      production.weight = [this, &rule](const grammar::Site& site) {
        const Value weight = eval(*rule.weight, site.key, names(rule.formals, site.symbol));
        const Number* n = weight.get<Number>();
        if (!n || !(n->value >= 0) || !std::isfinite(n->value))
          fail(rule.weight->where, "a weight is a number from 0 on, not " + to_string(weight));
        return n->value;
      };
    const std::string name = fmt::format("{}/{}", rule.head, number);
    for (const Item& item : rule.items) add(item, rule.formals, name, production.parts);
    grammar_.productions.push_back(std::move(production));
  }

  bool fail(const SourceLocation& where, const std::string& message) {
    evaluator_.diagnostics().error(where, message);
    throw Faulty{};
  }

  /// An item that has the whole scope, or all parts of a split of it.
  void add(const Item& item, const Formals& formals, const std::string& name,
           std::vector<grammar::Part>& parts) {
    if (item.kind != ItemKind::split) {
      parts.push_back(part(item, formals, name, nullptr, 0));
      return;
    }
    for (size_t i = 0; i < item.parts.size(); ++i)
      parts.push_back(part(item.parts[i], formals, fmt::format("{}/{}", name, i), &item, i));
  }

  /// `split` is what places it; null: it has the whole scope.
  grammar::Part part(const Item& item, const Formals& formals, const std::string& name,
                     const Item* split, size_t number) {
    grammar::Part out;
    out.where = item.where;
    out.symbol = item.name;
    out.terminal = item.kind == ItemKind::element || item.kind == ItemKind::value;
    if (item.kind == ItemKind::split) {
      out.symbol = name + '/' + item.name;
      grammar::Production inner;
      inner.symbol = out.symbol;
      inner.where = item.where;
      inner.name = "inside";
      add(item, formals, name, inner.parts);
      grammar_.productions.push_back(std::move(inner));
    }
    const int which = static_cast<int>(number);
    if (split)
      out.count = [this, split, &formals, which](const grammar::Site& site) {
        int64_t count = 0;
        for (const Cell& cell : placed(*split, formals, site.symbol).layout->cells)
          count += cell.part == which;
        return count;
      };
    out.content = [this, &item, split, &formals, which](const grammar::Site& site) {
      return content(item, split, formals, which, site);
    };
    return out;
  }

  grammar::Content content(const Item& item, const Item* split, const Formals& formals, int which,
                           const grammar::Site& site) {
    Scope scope = scope_of(site.symbol);
    const Rect whole = scope.rect;
    scope.key = site.key;
    scope.copies.clear();
    scope.given.clear();
    scope.layout.reset();
    scope.split.clear();
    Value value;
    if (split) {
      const Placed& all = placed(*split, formals, site.symbol);
      place(*all.layout, which, site.repetition, whole, scope);
      scope.layout = all.layout;
      scope.split = split->name;
      value = all.values[item.position];
    }
    // Arguments see the place that the part has been given.
    const scene::Scope known = names(formals, site.symbol, scope);
    grammar::Content out;
    if (item.kind == ItemKind::symbol) {
      for (Argument& argument : evaluator_.arguments(*item.expr, site.key, &known)) {
        if (argument.value.empty()) throw Faulty{};
        out.params.push_back(std::move(argument.value));
      }
    } else if (item.kind == ItemKind::split) {
      out.params = site.symbol.content.params;
    } else {
      scope.element = element(item, value, site.key, known);
    }
    out.text = grammar::to_string(
        {item.name, {item.kind == ItemKind::split ? std::vector<Value>{} : out.params, {}, {}}});
    out.text += fmt::format(" {} at ({}, {})", size_text(scope.rect), metres(scope.rect.x),
                            metres(scope.rect.y));
    if (!scope.copies.empty()) out.text += fmt::format(", {} times", 1 + scope.copies.size());
    out.payload = std::move(scope);
    return out;
  }

  /// Puts the scope where the layout has the part for the `repetition`th time.
  static void place(const Layout& layout, int which, int64_t repetition, const Rect& whole,
                    Scope& scope) {
    for (const Cell& cell : layout.cells) {
      if (cell.part != which || repetition-- > 0) continue;
      scope.rect = {whole.x + cell.rect.x, whole.y + cell.rect.y, cell.rect.width,
                    cell.rect.height};
      for (Placement copy : cell.copies) {
        if (copy.mirrored) copy.x += 2 * whole.x;
        scope.copies.push_back(copy);
      }
      scope.given = cell.given;
      scope.depth += cell.depth;
      scope.index = static_cast<double>(cell.index);
      scope.total = static_cast<double>(cell.total);
      return;
    }
  }

  ElementPtr element(const Item& item, Value value, RandomKey key, const scene::Scope& known) {
    if (item.kind == ItemKind::element) {
      Diagnostics found;
      const Arguments given = evaluator_.arguments(*item.expr, key, &known);
      for (const Argument& argument : given)
        if (argument.value.empty()) throw Faulty{};
      const auto made = item.element->make(given, item.where, found);
      evaluator_.tell(found, given);
      if (!made) throw Faulty{};
      return *made;
    }
    if (value.empty()) value = eval(*item.expr, key, known);
    if (const auto* made = value.object<ElementPtr>()) return *made;
    fail(item.where, fmt::format("'{}' is no element but {}", item.name, value.type_name()));
    return nullptr;
  }

  /// The split in the symbol's scope. One is kept, as all parts ask for it one after the other.
  const Placed& placed(const Item& split, const Formals& formals, const grammar::Symbol& symbol) {
    const Scope& scope = scope_of(symbol);
    if (last_ == &split && last_key_ == scope.key.state()) return placed_;
    placed_ = doing(symbol, split.where, [&] { return make(split, formals, symbol, scope); });
    last_ = &split;
    last_key_ = scope.key.state();
    return placed_;
  }

  Placed make(const Item& split, const Formals& formals, const grammar::Symbol& symbol,
              const Scope& scope) {
    const RandomKey key = scope.key.at("split").at(split.name).at(split.position);
    const scene::Scope known = names(formals, symbol);
    Placed out;
    out.values.resize(split.expr->operands.size());
    Arguments given;
    std::vector<Value> packed;
    const std::vector<ParamInfo>& params = split.split->info.params;
    const auto list = static_cast<size_t>(
        std::find_if(params.begin(), params.end(),
                     [](const ParamInfo& p) { return p.type.rfind("list of", 0) == 0; }) -
        params.begin());
    const bool packs = list < 2;  // a list that comes first takes all that has no name
    SourceLocation packed_where;
    for (size_t i = 0; i < split.expr->operands.size(); ++i) {
      const scene::Operand& operand = split.expr->operands[i];
      Value value = argument(split, i, key.at(i), known, out.values[i]);
      if (!operand.name.empty() || !packs || i < list) {
        for (size_t p = 0; p < params.size(); ++p)
          if ((operand.name.empty() ? p == i : params[p].name == operand.name) &&
              params[p].type.find("size") != std::string::npos)
            value = as_sizes(value);
        given.push_back({operand.name, std::move(value), operand.where});
      } else {
        if (packed.empty()) packed_where = operand.where;
        packed.push_back(as_sizes(value));
      }
    }
    if (!packed.empty())
      given.push_back({params[list].name, Value(List(packed.begin(), packed.end())), packed_where});
    Diagnostics found;
    const auto made = split.split->make(given, split.where, found);
    evaluator_.tell(found, given);
    if (!made) throw Faulty{};
    out.layout = std::make_shared<const Layout>(
        (*made)->layout(scope.rect.width, scope.rect.height, key.at("layout")));
    return out;
  }

  /// A part as a reference to it (an element that a name stands for goes to `named`), a choice as
  /// itself, anything else by its value.
  Value argument(const Item& split, size_t i, RandomKey key, const scene::Scope& known,
                 Value& named) {
    const scene::Expr& expr = *split.expr->operands[i].value;
    for (size_t p = 0; p < split.parts.size(); ++p) {
      const Item& part = split.parts[p];
      if (part.position != i) continue;
      if (part.kind == ItemKind::value) {
        named = eval(expr, key, known);
        if (!named.object<ElementPtr>()) return named;
      }
      return ValueTraits<PartRef>::write({static_cast<int>(p), part.name});
    }
    if (expr.kind == scene::ExprKind::name)
      for (const ParamInfo& param : split.split->info.params)
        for (const std::string& choice : param.choices)
          if (choice == expr.text) return Value::Name{expr.text};
    return eval(expr, key, known);
  }

  const Rules& rules_;
  scene::Evaluator& evaluator_;
  DeriveOptions options_;
  grammar::Grammar grammar_;
  Scope root_;
  const Item* last_ = nullptr;
  uint64_t last_key_ = 0;
  Placed placed_;
};

}  // namespace

std::optional<Derived> derive(const Rules& rules, scene::Evaluator& evaluator,
                              const DeriveOptions& options) {
  return Divider(rules, evaluator, options).run();
}

}  // namespace vug::facade
