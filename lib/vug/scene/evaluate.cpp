// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions: operators, calls, lists and vectors, seeded ranges and choices.
#include <vug/scene/evaluator.h>
#include <vug/scene/functions.h>
#include <vug/scene/list_functions.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::scene {

namespace {

constexpr int kMaxDepth = 2000;

/// Whether such an expression can have an object as its value, or a list of objects.
bool can_be_object(ExprKind kind) {
  return kind != ExprKind::number && kind != ExprKind::text && kind != ExprKind::truth &&
         kind != ExprKind::vector && kind != ExprKind::range;
}

/// The name in an argument or an element of it that is written at `where`; null if it is another
/// value.
const Value::Name* name_at(const Argument& argument, const SourceLocation& where) {
  if (argument.where == where) return argument.value.get<Value::Name>();
  const List* list = argument.value.get<List>();
  if (!list || list->size() != argument.elements.size()) return nullptr;
  for (size_t i = 0; i < list->size(); ++i)
    if (argument.elements[i] == where) return (*list)[i].get<Value::Name>();
  return nullptr;
}

bool is_axis(const std::string& name) { return name == "X" || name == "Y" || name == "Z"; }

class DepthScope {
 public:
  explicit DepthScope(int& depth) : depth_(depth) { ++depth_; }
  ~DepthScope() { --depth_; }
  DepthScope(const DepthScope&) = delete;
  DepthScope& operator=(const DepthScope&) = delete;

 private:
  int& depth_;
};

}  // namespace

Value Evaluator::evaluate(const Expr& expr, const Context& context) {
  const DepthScope depth(depth_);
  deepest_ = std::max(deepest_, depth_);
  if (depth_ > kMaxDepth) return site(expr).fault("values are nested too deeply");
  switch (expr.kind) {
    case ExprKind::number:
      return expr.number;
    case ExprKind::text:
      return expr.text;
    case ExprKind::truth:
      return expr.text == "true";
    case ExprKind::name:
      return name(expr, context);
    case ExprKind::vector:
    case ExprKind::list:
      return parts(expr, context);
    case ExprKind::unary:
      return unary(expr, context);
    case ExprKind::binary:
      return expr.text == "and" || expr.text == "or" ? logical(expr, context)
                                                     : binary(expr, context);
    case ExprKind::range:
      return range(expr, context);
    case ExprKind::call:
      return call(expr, context);
    case ExprKind::index:
      return element(expr, context);
    case ExprKind::comprehension:
      return comprehension(expr, context);
    case ExprKind::broken:
      break;
  }
  return {};
}

Value Evaluator::name(const Expr& expr, const Context& context) {
  if (auto value = find_local(expr, context.scope)) return *std::move(value);
  const std::string full = full_name(expr);
  if (!context.expected.empty())  // several declarations, or a let, may share the name
    if (auto value = declaration(full, expr.where, context.expected)) return *std::move(value);
  if (const auto known = globals_.find(full); known != globals_.end())
    return global(full, known->second, expr.where);
  if (expr.text == "pi") return kPi;
  if (expr.text == "frame") {
    resolver_.use_frame();
    return options_.frame;
  }
  // A mesh `m` hides no metre: declarations are used where their kind is expected.
  if (const auto unit = with_unit(1, expr.text)) return *unit;
  if (auto value = declaration(full, expr.where, {})) return *std::move(value);
  if (document_.skipped.may_declare(expr.text)) return {};
  return Value::Name{expr.text};
}

/// The declaration of that name, of the expected type or (empty) the first one.
std::optional<Value> Evaluator::declaration(const std::string& full, const SourceLocation& where,
                                            std::string_view expected) {
  const int deepest = deepest_;  // declarations have their own limits
  auto value = expected.empty()
                   ? resolver_.name(full, where, *diagnostics_)
                   : resolver_.declared(std::string(expected), full, where, *diagnostics_);
  deepest_ = deepest;
  return value;
}

/// Returns false, with an error, for an unknown name where a value is needed.
bool Evaluator::is_known(const Value& value, const Expr& expr) {
  const auto* unknown = value.get<Value::Name>();
  if (!unknown) return true;
  const std::string hint = name_hint(unknown->text);
  site(expr).fault(fmt::format("unknown name '{}'", unknown->text), hint);
  return false;
}

Value Evaluator::parts(const Expr& expr, const Context& context) {
  List list;
  bool sound = true;
  for (const Operand& part : expr.operands) {
    list.push_back(evaluate(*part.value, context));
    if (list.back().empty()) sound = false;
  }
  if (!sound) return {};
  if (expr.kind == ExprKind::list) return checked_size(std::move(list), expr);
  std::vector<Number> numbers;
  for (size_t i = 0; i < list.size(); ++i) {
    const Expr& part = *expr.operands[i].value;
    if (!is_known(list[i], part)) return {};
    const Number* n = list[i].get<Number>();
    if (!n)
      return site(part).fault(
          fmt::format("the components of a vector must be numbers, not {}", list[i].type_name()),
          "write a list in [ ]");
    numbers.push_back(*n);
  }
  return vector_of(std::move(numbers), site(expr));
}

/// The list as a value, unless it has too many elements.
Value Evaluator::checked_size(List list, const Expr& expr) {
  Value value(std::move(list));
  return may_have_elements(value.element_count(), site(expr)) ? value : Value();
}

Value Evaluator::unary(const Expr& expr, const Context& context) {
  const Expr& inner = *expr.operands[0].value;
  if (expr.text == "not") {
    const auto value = truth(inner, context);
    return value ? Value(!*value) : Value();
  }
  const Value value = evaluate(inner, context);
  if (value.empty()) return {};
  const char op = expr.text[0];
  // Directions such as +X and -Z are names.
  if (const auto* axis = value.get<Value::Name>(); axis && is_axis(axis->text))
    return Value::Name{expr.text + axis->text};
  if (const auto* letter = value.get<Value::Name>(); letter && letter->text.size() == 1)
    return site(expr).fault(
        fmt::format("cannot apply '{}' to the unknown name '{}'", op, letter->text),
        "directions are +X, -X, +Y, -Y, +Z and -Z");
  if (!is_known(value, inner)) return {};
  if (auto result = negate(op, value)) return *std::move(result);
  if (value.get<Object>())
    if (auto result = resolver_.unary(op, value, expr.where, *diagnostics_))
      return *std::move(result);
  return site(expr).fault(fmt::format("cannot apply '{}' to {}", op, value.type_name()));
}

Value Evaluator::binary(const Expr& expr, const Context& context) {
  const Expr& left = *expr.operands[0].value;
  const Expr& right = *expr.operands[1].value;
  const Value a = evaluate(left, context);
  const Value b = evaluate(right, context);
  if (a.empty() || b.empty()) return {};
  if (!spend_on(a, expr.where) || !spend_on(b, expr.where)) return {};
  const bool comparison = std::string_view("<>=!").find(expr.text[0]) != std::string_view::npos;
  if (comparison) {
    if (auto result = compare(expr.text, a, b, site(expr))) return *std::move(result);
  } else {
    if (auto result = arithmetic(expr.text[0], a, b, site(expr))) return *std::move(result);
  }
  const bool left_known = is_known(a, left), right_known = is_known(b, right);
  if (!left_known || !right_known) return {};
  if (!comparison && (a.get<Object>() || b.get<Object>()))
    if (auto result = resolver_.binary(expr.text[0], a, b, expr.where, *diagnostics_))
      return *std::move(result);
  return site(expr).fault(
      fmt::format("cannot apply '{}' to {} and {}", expr.text, a.type_name(), b.type_name()),
      expr.text == "+" && a.get<List>() && b.get<List>() ? "join lists with concat(a, b)" : "");
}

std::optional<bool> Evaluator::truth(const Expr& expr, const Context& context) {
  const Value value = evaluate(expr, context);
  if (value.empty() || !is_known(value, expr)) return std::nullopt;
  if (const bool* truth = value.get<bool>()) return *truth;
  site(expr).fault(fmt::format("expected true or false, not {}", value.type_name()));
  return std::nullopt;
}

Value Evaluator::logical(const Expr& expr, const Context& context) {
  const auto left = truth(*expr.operands[0].value, context);
  if (!left) return {};
  if (*left == (expr.text == "or")) return *left;
  const auto right = truth(*expr.operands[1].value, context);
  return right ? Value(*right) : Value();
}

Value Evaluator::range(const Expr& expr, const Context& context) {
  const Expr& low = *expr.operands[0].value;
  const Expr& high = *expr.operands[1].value;
  const Value a = evaluate(low, context);
  const Value b = evaluate(high, context);
  if (a.empty() || b.empty()) return {};
  const bool low_known = is_known(a, low), high_known = is_known(b, high);
  if (!low_known || !high_known) return {};
  RandomStream stream(context.key.at(expr.path));
  const Number* na = a.get<Number>();
  const Number* nb = b.get<Number>();
  if (na && nb) {
    Number x = *na, y = *nb;
    if (!unify_dimensions(x, y, "a range cannot mix", site(expr))) return {};
    if (x.value > y.value)
      return site(expr).fault(fmt::format("invalid range {}..{}: the first end exceeds the second",
                                          quantity_text(x.value, x.dimension),
                                          quantity_text(y.value, y.dimension)));
    return Number{stream.uniform(x.value, y.value), x.dimension};
  }
  const auto* va = a.get<Value::Vector>();
  const auto* vb = b.get<Value::Vector>();
  if (!va || !vb)
    return site(expr).fault(
        fmt::format("cannot form a range from {} to {}", a.type_name(), b.type_name()));
  Number x{va->value == Vec3d(0) ? 0.0 : 1.0, va->dimension};
  Number y{vb->value == Vec3d(0) ? 0.0 : 1.0, vb->dimension};
  if (!unify_dimensions(x, y, "a range cannot mix", site(expr))) return {};
  Vec3d point;
  for (int axis = 0; axis < 3; ++axis) {
    if (va->value[axis] > vb->value[axis])
      return site(expr).fault(
          "invalid range of vectors: a component of the first end exceeds that of the second");
    point[axis] = stream.uniform(va->value[axis], vb->value[axis]);
  }
  return Value::Vector{point, x.dimension};
}

/// if(condition, then, else): evaluates only the selected branch.
Value Evaluator::choose(const Expr& expr, const Context& context) {
  if (expr.operands.size() != 3)
    return site(expr).fault("'if' takes a condition and two values",
                            "write if(condition, then, else)");
  const auto condition = truth(*expr.operands[0].value, context);
  if (!condition) return {};
  return evaluate(*expr.operands[*condition ? 1 : 2].value, context);
}

/// pick(a, b, c) or pick([a, b, c]): one of them, with equal probability.
Value Evaluator::pick(const Expr& expr, const Context& context) {
  const size_t count = expr.operands.size();
  if (count == 0) return site(expr).fault("'pick' needs at least one value");
  RandomStream stream(context.key.at(expr.path));
  if (count > 1)
    return evaluate(*expr.operands[stream.below(static_cast<uint32_t>(count))].value, context);
  const Value value = evaluate(*expr.operands[0].value, context);
  const List* list = value.get<List>();
  if (!list) return value;
  if (list->empty()) return site(expr).fault("'pick' needs at least one value");
  return (*list)[stream.below(static_cast<uint32_t>(list->size()))];
}

Arguments Evaluator::arguments(const Expr& call, RandomKey key, const Scope* scope) {
  Arguments arguments;
  if (call.kind != ExprKind::call) return arguments;
  for (size_t i = 0; i < call.operands.size(); ++i) {
    const Operand& part = call.operands[i];
    const bool word = part.value->kind == ExprKind::name;
    const std::string_view expected = can_be_object(part.value->kind)
                                          ? resolver_.expected_type(call.text, i, part.name)
                                          : std::string_view();
    const bool choice = word && resolver_.is_choice(call.text, i, part.name, part.value->text);
    Value value = choice ? Value(Value::Name{part.value->text})
                         : evaluate(*part.value, {key, scope_or_default(scope), expected});
    Argument& made = arguments.emplace_back(Argument{part.name, std::move(value), part.where});
    if (part.value->kind == ExprKind::list)
      for (const Operand& element : part.value->operands) made.elements.push_back(element.where);
  }
  return arguments;
}

void Evaluator::report(const Diagnostics& found, const Arguments& given) {
  for (Diagnostic one : found.all()) {
    for (const Argument& argument : given)
      if (const auto* unknown = name_at(argument, one.where); unknown && one.hint.empty())
        one.hint = name_hint(unknown->text);
    diagnostics_->add(std::move(one));
  }
}

std::optional<Value> Evaluator::resolved(const Expr& call, const Arguments& given, RandomKey key,
                                         std::string_view expected) {
  Diagnostics found;
  std::optional<Value> result;
  try {
    result = resolver_.call(call.text, given, call.where, {key, expected}, found);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    found.add(error, call.where);
    result = Value();
  }
  report(found, given);
  return result;
}

Value Evaluator::call(const Expr& expr, const Context& context) {
  if (expr.text == "if") return choose(expr, context);
  if (expr.text == "pick") return pick(expr, context);
  if (expr.text == "keys") return keys(expr, context);
  if (is_module_call(expr)) return call_member(expr, context);
  if (const auto def = defs_.find(full_name(expr)); def != defs_.end())
    return call_def(def->second, expr, 0, context);
  const Arguments given = arguments(expr, context.key, context.scope);
  const bool reported = std::any_of(given.begin(), given.end(),
                                    [](const Argument& each) { return each.value.empty(); });
  const Function* builtin = find_function(expr.text);
  if (!builtin || builtin->reads_elements)
    for (const Argument& argument : given)
      if (!spend_on(argument.value, expr.where)) return {};
  if (builtin && reported) return {};
  if (builtin)
    if (auto result = builtin->apply(given, site(expr))) return *std::move(result);
  if (auto result = resolved(expr, given, context.key.at(expr.path), context.expected))
    return reported ? Value() : *std::move(result);
  for (size_t i = 0; builtin && i < given.size(); ++i)
    if (!is_known(given[i].value, *expr.operands[i].value)) return {};
  if (builtin)
    return site(expr).fault(
        fmt::format("'{}' takes {}{}", expr.text, builtin->takes,
                    given.size() == 1 ? ", not " + given[0].value.type_name() : ""));
  if (globals_.count(full_name(expr))) {
    diagnostics_->error(word_at(expr.where, expr.text),
                        fmt::format("'{}' is a value, not a function", expr.text),
                        fmt::format("functions are declared by 'def {}(...) = ...'", expr.text));
    return {};
  }
  report_unknown_function(expr);
  return {};
}

}  // namespace vug::scene
