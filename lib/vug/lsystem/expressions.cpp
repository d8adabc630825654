// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/expressions.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

namespace {

using scene::Expr;
using scene::ExprKind;

/// Change of the stack height by the operation.
int stack_change(Op op) {
  switch (op) {
    case Op::constant:
    case Op::formal:
    case Op::times_formal:
    case Op::plus_formal:
    case Op::choose:
      return 1;
    case Op::negate:
    case Op::opposite:
    case Op::jump:
    case Op::call1:
      return 0;
    case Op::call3:
      return -2;
    default:
      return -1;
  }
}

struct Sign {
  const char* text;
  Op op;
  bool compares;
};
constexpr Sign kSigns[] = {
    {"+", Op::add, false},        {"-", Op::subtract, false}, {"*", Op::multiply, false},
    {"/", Op::divide, false},     {"^", Op::power, false},    {"<", Op::less, true},
    {"<=", Op::less_equal, true}, {">", Op::greater, true},   {">=", Op::greater_equal, true},
    {"==", Op::equal, true},      {"!=", Op::unequal, true}};

template <class Functions>
std::optional<uint32_t> place_of(const Functions& all, const std::string& name) {
  for (uint32_t i = 0; i < all.size(); ++i)
    if (name == all[i].name) return i;
  return std::nullopt;
}

}  // namespace

void Expressions::fail(const Expr& expr, std::string message, std::string hint) {
  evaluator_.diagnostics().error(expr.where, std::move(message), std::move(hint));
  throw AlreadyReported{};
}

std::optional<uint32_t> Expressions::formal(const std::string& name) const {
  const auto found = std::find(formals_.begin(), formals_.end(), name);
  if (found == formals_.end()) return std::nullopt;
  return static_cast<uint32_t>(found - formals_.begin());
}

bool Expressions::is_constant(const Expr& expr) const {
  if (expr.kind == ExprKind::range) return false;
  if (expr.kind == ExprKind::call && expr.text == "pick") return false;
  if (expr.kind == ExprKind::name && formal(expr.text)) return false;
  return std::all_of(expr.operands.begin(), expr.operands.end(),
                     [&](const scene::Operand& part) { return is_constant(*part.value); });
}

std::optional<Value> Expressions::constant(const Expr& expr) {
  if (!is_constant(expr)) return std::nullopt;
  const Value value = evaluator_.eval(expr, evaluator_.root());
  if (value.empty()) throw AlreadyReported{};
  const auto* unknown = value.get<Value::Name>();
  if (unknown && expr.kind == ExprKind::name)
    fail(expr, fmt::format("unknown name '{}'", unknown->text),
         suggestion(unknown->text, formals_));
  return value;
}

void Expressions::put(Program& program, Op op, uint32_t index, double value) {
  program.code.push_back({op, index, value});
  height_ += stack_change(op);
  program.depth = std::max(program.depth, height_);
}

size_t Expressions::jump(Program& program, Op op) {
  put(program, op);
  return program.code.size() - 1;
}

void Expressions::land(Program& program, size_t jump) const {
  program.code[jump].index = static_cast<uint32_t>(program.code.size());
}

void Expressions::expect(const Expr& expr, Type type, Program& program) {
  if (program.empty()) height_ = 0;
  if (compile(expr, program) == type) return;
  fail(expr, type == Type::number ? "expected a number, not true or false"
                                  : "expected true or false, not a number");
}

Expressions::Type Expressions::compile(const Expr& expr, Program& program) {
  if (is_constant(expr)) return fold(expr, program);
  switch (expr.kind) {
    case ExprKind::name:
      put(program, Op::formal, *formal(expr.text));
      return Type::number;
    case ExprKind::unary:
      return unary(expr, program);
    case ExprKind::binary:
      return expr.text == "and" || expr.text == "or" ? logical(expr, program)
                                                     : binary(expr, program);
    case ExprKind::range:
      for (const scene::Operand& side : expr.operands) number(*side.value, program);
      put(program, Op::draw);
      draws_ = true;
      return Type::number;
    case ExprKind::call:
      return call(expr, program);
    default:
      fail(expr, "expressions of modules can only use numbers");
  }
}

Expressions::Type Expressions::fold(const Expr& expr, Program& program) {
  const Value value = *constant(expr);
  if (const Number* n = value.get<Number>()) {
    put(program, Op::constant, 0, n->value);
    return Type::number;
  }
  if (const bool* truth = value.get<bool>()) {
    put(program, Op::constant, 0, *truth ? 1 : 0);
    return Type::truth;
  }
  fail(expr, fmt::format("expressions of modules can only use numbers, not {}", value.type_name()));
}

Expressions::Type Expressions::unary(const Expr& expr, Program& program) {
  const Expr& inner = *expr.operands[0].value;
  if (expr.text == "not") {
    truth(inner, program);
    put(program, Op::opposite);
    return Type::truth;
  }
  number(inner, program);
  if (expr.text == "-") put(program, Op::negate);
  return Type::number;
}

/// Fuses an operation on a formal and a constant into one instruction.
bool Expressions::fuse(Program& program, Op op, size_t left, size_t right) const {
  std::vector<Instruction>& code = program.code;
  if (right - left != 1 || code.size() - right != 1) return false;
  Instruction a = code[left], b = code[right];
  const bool commutes = op == Op::add || op == Op::multiply;
  if (commutes && a.op == Op::constant) std::swap(a, b);
  if (a.op != Op::formal || b.op != Op::constant) return false;
  if (op == Op::multiply)
    a = {Op::times_formal, a.index, b.value};
  else if (op == Op::add || op == Op::subtract)
    a = {Op::plus_formal, a.index, op == Op::add ? b.value : -b.value};
  else
    return false;
  code.resize(left);
  code.push_back(a);
  return true;
}

Expressions::Type Expressions::binary(const Expr& expr, Program& program) {
  const auto* const sign = std::find_if(std::begin(kSigns), std::end(kSigns),
                                        [&](const Sign& one) { return expr.text == one.text; });
  if (sign == std::end(kSigns))
    fail(expr, fmt::format("expressions of modules cannot use '{}'", expr.text));
  const size_t left = program.code.size();
  number(*expr.operands[0].value, program);
  const size_t right = program.code.size();
  number(*expr.operands[1].value, program);
  if (fuse(program, sign->op, left, right))
    --height_;
  else
    put(program, sign->op);
  return sign->compares ? Type::truth : Type::number;
}

Expressions::Type Expressions::logical(const Expr& expr, Program& program) {
  const bool both = expr.text == "and";
  truth(*expr.operands[0].value, program);
  if (!both) put(program, Op::opposite);
  const size_t decided = jump(program, Op::jump_if_zero);
  truth(*expr.operands[1].value, program);
  const size_t end = jump(program, Op::jump);
  --height_;
  land(program, decided);
  put(program, Op::constant, 0, both ? 0 : 1);
  land(program, end);
  return Type::truth;
}

Expressions::Type Expressions::choose(const Expr& expr, Program& program) {
  if (expr.operands.size() != 3)
    fail(expr, "'if' takes a condition and two values", "write if(condition, then, else)");
  truth(*expr.operands[0].value, program);
  const size_t otherwise = jump(program, Op::jump_if_zero);
  const Type type = compile(*expr.operands[1].value, program);
  const size_t end = jump(program, Op::jump);
  --height_;
  land(program, otherwise);
  expect(*expr.operands[2].value, type, program);
  land(program, end);
  return type;
}

/// pick(a, b, c): a with probability 1/3, else b with probability 1/2, else c.
Expressions::Type Expressions::pick(const Expr& expr, Program& program) {
  std::vector<const Expr*> from;
  const bool list = expr.operands.size() == 1 && expr.operands[0].value->kind == ExprKind::list;
  for (const scene::Operand& part : (list ? *expr.operands[0].value : expr).operands)
    from.push_back(part.value.get());
  if (from.empty()) fail(expr, "'pick' needs at least one value");
  std::vector<size_t> ends;
  for (size_t i = 0; i + 1 < from.size(); ++i) {
    put(program, Op::choose, 0, static_cast<double>(from.size() - i));
    draws_ = true;
    put(program, Op::opposite);
    const size_t next = jump(program, Op::jump_if_zero);
    number(*from[i], program);
    ends.push_back(jump(program, Op::jump));
    --height_;
    land(program, next);
  }
  number(*from.back(), program);
  for (const size_t end : ends) land(program, end);
  return Type::number;
}

Expressions::Type Expressions::call(const Expr& expr, Program& program) {
  if (expr.text == "if") return choose(expr, program);
  if (expr.text == "pick") return pick(expr, program);
  const size_t count = expr.operands.size();
  for (const scene::Operand& part : expr.operands)
    if (!part.name.empty())
      fail(expr, fmt::format("'{}' takes its numbers by position", expr.text));
  const std::optional<uint32_t> place = count == 1   ? place_of(functions1(), expr.text)
                                        : count == 2 ? place_of(functions2(), expr.text)
                                        : count == 3 ? place_of(functions3(), expr.text)
                                                     : std::nullopt;
  if (place) {
    for (const scene::Operand& part : expr.operands) number(*part.value, program);
    put(program, count == 1 ? Op::call1 : count == 2 ? Op::call2 : Op::call3, *place);
    return Type::number;
  }
  const bool extreme = count > 2 && (expr.text == "min" || expr.text == "max");
  if (extreme) {  // min or max of more than two numbers
    for (size_t i = 0; i < count; ++i) {
      number(*expr.operands[i].value, program);
      if (i > 0) put(program, Op::call2, *place_of(functions2(), expr.text));
    }
    return Type::number;
  }
  std::vector<std::string> known{"if", "pick"};
  for (const auto& one : functions1()) known.emplace_back(one.name);
  for (const auto& one : functions2()) known.emplace_back(one.name);
  for (const auto& one : functions3()) known.emplace_back(one.name);
  fail(expr,
       fmt::format("no function '{}' of {} number{} is available to modules", expr.text, count,
                   count == 1 ? "" : "s"),
       suggestion(expr.text, known));
}

}  // namespace vug::lsystem
