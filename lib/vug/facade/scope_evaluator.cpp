// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/scope_evaluator.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::facade {

std::string metres(double value) { return fmt::format("{:.4g}", value); }

std::string size_text(const Rect& r) {
  return fmt::format("{} x {} m", metres(r.width), metres(r.height));
}

namespace {

void check_sizes(const Layout& layout, double least, const Item& split) {
  for (const Cell& cell : layout.cells)
    if (const double size = std::min(cell.rect.width, cell.rect.height); size < least)
      throw InfeasiblePlan(Reason::too_small, "",
                           fmt::format("'{}' would be {}; the minimum is {} m",
                                       split.parts.at(static_cast<size_t>(cell.part)).name,
                                       size_text(cell.rect), metres(least)));
}

/// The numbers whose names start with the prefix, which is removed.
NumberValues numbers_of(const NumberValues& all, const std::string& prefix) {
  NumberValues out;
  for (const auto& [name, values] : all)
    if (prefix.empty() ? name.find('.') == name.npos : name.rfind(prefix, 0) == 0)
      out[name.substr(prefix.size())] = values;
  return out;
}

}  // namespace

bool ScopeEvaluator::fail(const SourceLocation& where, const std::string& message) {
  evaluator_.diagnostics().error(where, message);
  throw AlreadyReported{};
}

Value ScopeEvaluator::eval(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) {
  Value value = evaluator_.eval(expr, key, &scope);
  if (value.empty()) throw AlreadyReported{};
  return value;
}

ElementPtr ScopeEvaluator::element(const Item& item, Value value, RandomKey key,
                                   const scene::Scope& known) {
  if (item.kind == ItemKind::element) {
    Diagnostics found;
    const Arguments given = evaluator_.arguments(*item.expr, key, &known);
    for (const Argument& argument : given)
      if (argument.value.empty()) throw AlreadyReported{};
    const auto made = item.element->make(given, item.where, found);
    evaluator_.report(found, given);
    if (!made) throw AlreadyReported{};
    return *made;
  }
  if (value.empty()) value = eval(*item.expr, key, known);
  if (const auto* made = value.object<ElementPtr>()) return *made;
  fail(item.where, fmt::format("'{}' is not an element but {}", item.name, value.type_name()));
  return nullptr;
}

EvaluatedSplit ScopeEvaluator::place(const Item& item, const Scope& scope,
                                     const scene::Scope& known, const PlanOptions* planning,
                                     const std::string& prefix) {
  const RandomKey key = scope.key.at("split").at(item.name).at(item.position);
  EvaluatedSplit out;
  const SplitPtr made = split(item, key, known, out.values);
  static const Plan nothing;
  const Plan& plan = scope.plan ? *scope.plan : nothing;
  FreeNumbers free = planning ? FreeNumbers(numbers_of(plan.numbers, prefix), plan.apart)
                              : FreeNumbers(key.at("layout"));
  Layout layout = made->layout(scope.rect.width, scope.rect.height, free);
  free.check_all_used();
  if (planning) check_sizes(layout, planning->least, item);
  std::erase_if(layout.cells, [&](const Cell& cell) {
    return cell.copies.empty() && plan.off.count({cell.column, cell.row}) > 0;
  });
  out.layout = std::make_shared<const Layout>(std::move(layout));
  out.free = free.requested();
  for (FreeNumber& number : out.free) number.name = prefix + number.name;
  return out;
}

SplitPtr ScopeEvaluator::split(const Item& split, RandomKey key, const scene::Scope& known,
                               std::vector<Value>& values) {
  values.resize(split.expr->operands.size());
  Arguments given;
  std::vector<Value> packed;
  const std::vector<ParamInfo>& params = split.split->info.params;
  const auto list = static_cast<size_t>(
      std::find_if(params.begin(), params.end(),
                   [](const ParamInfo& p) { return p.type.rfind("list of", 0) == 0; }) -
      params.begin());
  const bool packs = list < 2;  // a leading list parameter takes all positional arguments
  SourceLocation packed_where;
  for (size_t i = 0; i < split.expr->operands.size(); ++i) {
    const scene::Operand& operand = split.expr->operands[i];
    Value value = argument(split, i, key.at(i), known, values[i]);
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
  evaluator_.report(found, given);
  if (!made) throw AlreadyReported{};
  return *made;
}

/// Evaluates an argument: a part becomes a reference (`named` receives the element that a name
/// refers to), a choice is kept as a name, everything else is evaluated.
Value ScopeEvaluator::argument(const Item& split, size_t i, RandomKey key,
                               const scene::Scope& known, Value& named) {
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

}  // namespace vug::facade
