// SPDX-License-Identifier: Apache-2.0
// Evaluation of comprehensions and indices, and the limit on the work of loops and functions.
#include <vug/scene/evaluator.h>
#include <vug/scene/functions.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::scene {

namespace {

/// Maximum number of calls and loop iterations of one expression.
constexpr double kMaxWork = 1e6;
/// Loops inside loops whose lengths vary may plan more than they do; beyond this factor they cannot
/// be expected to fit.
constexpr double kSlack = 4;

/// Multiplies a factor for its lifetime.
class FactorScope {
 public:
  FactorScope(double& factor, double by) : factor_(factor), before_(factor) { factor *= by; }
  ~FactorScope() { factor_ = before_; }
  FactorScope(const FactorScope&) = delete;
  FactorScope& operator=(const FactorScope&) = delete;

 private:
  double& factor_;
  double before_;
};

}  // namespace

/// The elements of a comprehension while its loops run.
struct Evaluator::LoopResult {
  std::vector<Binding> values;  ///< Without names.
  std::vector<Value> keys;      ///< Values of `sort by`; empty without it.
};

/// Reports work that exceeds the limit: what is done so far, or what the loops around would do in
/// all.
bool Evaluator::admit(double work, const char* what, const SourceLocation& where) {
  const double planned = planned_ * work;
  const bool excessive = planned > kSlack * kMaxWork;
  if (!excessive && ++done_ <= kMaxWork) return true;
  FaultSite{where, *diagnostics_}.fault(
      excessive ? fmt::format("this would take {:.0f} {}", planned, what)
                : fmt::format("this takes more than {:.0f} {}", kMaxWork, what),
      fmt::format("at most {:.0f} are allowed in one expression", kMaxWork));
  return false;
}

/// Reports work on long lists and texts that exceeds the limit, as in a loop around it.
bool Evaluator::spend_on(const Value& value, const SourceLocation& where) {
  constexpr double kElements = 20, kBytes = 500;  // these take the time of one iteration
  if (value.get<List>())
    done_ += static_cast<double>(value.element_count()) / kElements;
  else if (const auto* text = value.get<std::string>())
    done_ += static_cast<double>(text->size()) / kBytes;
  else
    return true;
  if (done_ <= kMaxWork) return true;
  FaultSite{where, *diagnostics_}.fault(
      "the loops around this take too long: its lists or texts are read too often",
      "name a value that does not change with 'let' or 'where'");
  return false;
}

/// The whole numbers of `lo..hi`, both included; `lo..lo - 1` is empty.
std::optional<List> Evaluator::whole_numbers(const Expr& range, const Context& context) {
  double ends[2] = {0, 0};
  for (size_t i = 0; i < 2; ++i) {
    const Expr& end = *range.operands[i].value;
    const Value value = evaluate(end, context);
    if (value.empty() || !is_known(value, end)) return std::nullopt;
    const Number* n = value.get<Number>();
    if (!n || n->dimension != Dimension::none || n->value != std::floor(n->value) ||
        std::fabs(n->value) > 1e15) {
      site(end).fault(fmt::format("a loop counts in whole numbers, not from or to {}",
                                  n ? to_string(value) : value.type_name()),
                      "[for i in 0..5: i * 20cm]");
      return std::nullopt;
    }
    ends[i] = n->value;
  }
  const double count = ends[1] - ends[0] + 1;
  if (count < 0) {
    site(range).fault(fmt::format("a loop cannot count from {} down to {}", ends[0], ends[1]),
                      fmt::format("write {}..{} and use the mirrored number", ends[1], ends[0]));
    return std::nullopt;
  }
  if (planned_ * count > kSlack * kMaxWork) {
    admit(count, "loop iterations", range.where);
    return std::nullopt;
  }
  List numbers;
  for (double i = 0; i < count; ++i) numbers.emplace_back(ends[0] + i);
  return numbers;
}

/// The elements over which a `for` runs, with their nesting depth; no value after an error.
Binding Evaluator::elements(const Expr& expr, const Context& context) {
  if (expr.kind == ExprKind::range) {
    auto numbers = whole_numbers(expr, context);
    return {"", numbers ? Value(*std::move(numbers)) : Value()};
  }
  Binding list = measured("", expr, context);
  if (list.value.empty() || !is_known(list.value, expr)) return {"", {}};
  if (list.value.get<List>()) return list;
  return {"", site(expr).fault(fmt::format("'for' needs a list or a range such as 0..5, not {}",
                                           list.value.type_name()))};
}

/// Binds the variables of a `for` to an element; several variables take a list apart.
bool Evaluator::bind(const Operand& clause, const Value& element, int height, Scope& scope) {
  if (clause.binds.size() == 1) {
    scope.names.emplace_back(clause.binds[0].name, element, height);
    return true;
  }
  const List* list = element.get<List>();
  if (!list || list->size() != clause.binds.size()) {
    FaultSite{clause.where, *diagnostics_}.fault(
        fmt::format(
            "{} variables cannot take {} apart", clause.binds.size(),
            list ? fmt::format("a list of {} elements", list->size()) : element.type_name()),
        "each element must be a list with one value for each variable, as zip(a, b) makes them");
    return false;
  }
  for (size_t i = 0; i < list->size(); ++i)
    scope.names.emplace_back(clause.binds[i].name, (*list)[i], height);
  return true;
}

/// Runs the clauses from number `clause` on; false after an error.
bool Evaluator::run_loop(const Expr& expr, size_t clause, const Context& context,
                         LoopResult& result) {
  const Operand& here = expr.operands[clause];
  if (here.name == "if") {
    const auto holds = truth(*here.value, context);
    return holds && (!*holds || run_loop(expr, clause + 1, context, result));
  }
  if (here.name != "for") {
    if (here.name == "sort") {
      result.keys.push_back(evaluate(*here.value, context));
      if (result.keys.back().empty() || !is_known(result.keys.back(), *here.value)) return false;
    }
    const Expr& value = *expr.operands.back().value;
    result.values.push_back(measured("", value, context));
    return !result.values.back().value.empty();
  }
  const Binding all = elements(*here.value, {context.key, context.scope, {}});
  if (all.value.empty()) return false;
  const List& list = *all.value.get<List>();
  const FactorScope planned(planned_, static_cast<double>(std::max<size_t>(list.size(), 1)));
  for (size_t i = 0; i < list.size(); ++i) {
    if (!admit(1, "loop iterations", here.where)) return false;
    Scope scope{{}, context.scope, nullptr};
    if (!bind(here, list[i], all.height, scope)) return false;
    // A number keeps its draws when the range is extended.
    const Number* number = here.value->kind == ExprKind::range ? list[i].get<Number>() : nullptr;
    const auto place = number ? static_cast<uint64_t>(static_cast<int64_t>(number->value)) : i;
    const Context inside{context.key.at("for").at(place), &scope, context.expected};
    if (!run_loop(expr, clause + 1, inside, result)) return false;
  }
  return true;
}

Value Evaluator::comprehension(const Expr& expr, const Context& context) {
  LoopResult result;
  if (!run_loop(expr, 0, context, result)) return {};
  std::vector<size_t> order(result.values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  if (!result.keys.empty() &&
      !sort(result.keys, order, *expr.operands[expr.operands.size() - 2].value))
    return {};
  List list;
  for (const size_t i : order) {
    deepest_ = std::max(deepest_, depth_ + result.values[i].height);
    list.push_back(std::move(result.values[i].value));
  }
  return checked_size(std::move(list), expr);
}

/// Sorts `order` by the keys, which are numbers of one dimension or texts; equal keys keep their
/// order.
bool Evaluator::sort(const std::vector<Value>& keys, std::vector<size_t>& order, const Expr& by) {
  std::vector<Number> numbers;
  std::vector<std::string> texts;
  for (const Value& key : keys) {
    if (const Number* n = key.get<Number>()) numbers.push_back(*n);
    if (const auto* text = key.get<std::string>()) texts.push_back(*text);
  }
  if (texts.size() == keys.size()) {
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return texts[a] < texts[b]; });
    return true;
  }
  if (numbers.size() != keys.size()) {
    const auto odd = std::find_if(keys.begin(), keys.end(), [](const Value& key) {
      return !key.get<Number>() && !key.get<std::string>();
    });
    site(by).fault(odd != keys.end() ? fmt::format("cannot sort by {}", odd->type_name())
                                     : std::string("cannot sort by numbers and texts together"),
                   "'sort by' needs a number or a text for each element");
    return false;
  }
  for (Number& n : numbers)
    if (!unify_dimensions(numbers[0], n, "cannot sort", site(by))) return false;
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return numbers[a].value < numbers[b].value; });
  return true;
}

/// list[index], counted from 0.
Value Evaluator::element(const Expr& expr, const Context& context) {
  const Expr& base = *expr.operands[0].value;
  const Expr& at = *expr.operands[1].value;
  const Value list = evaluate(base, context);
  const Value index = evaluate(at, {context.key, context.scope, {}});
  if (list.empty() || index.empty() || !is_known(list, base) || !is_known(index, at)) return {};
  const Arguments arguments = {{"", list, base.where}, {"", index, at.where}};
  if (auto found = find_function("at")->apply(arguments, site(expr))) return *std::move(found);
  if (!list.get<List>() && !list.get<Value::Vector>())
    return site(base).fault(
        fmt::format("only lists and vectors have elements, not {}", list.type_name()));
  return site(at).fault(fmt::format("an index is a plain number, not {}", index.type_name()));
}

}  // namespace vug::scene
