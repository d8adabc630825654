// SPDX-License-Identifier: Apache-2.0
#include <vug/language/literal_frame.h>
#include <vug/scene/parser.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::language {
namespace {

/// Lets that use each other; a longer chain is a cycle.
constexpr int kMostLets = 40;

OpenCall open_call(const scene::Expr& call) {
  OpenCall out;
  out.name = call.text;
  out.method = call.method;
  for (const scene::Operand& each : call.operands)
    if (!each.name.empty()) out.given.insert(each.name);
  return out;
}

/// The map of a deformer from the space of its solid.
std::optional<Transform> map_of(const scene::Expr& call, const KindInfo& info,
                                PlainEvaluator& values) {
  const auto given = [&](const char* param) { return operand_for(call, info, param); };
  const auto vector = [&](const char* param, const Vec3d& otherwise) -> std::optional<Vec3d> {
    return given(param) ? values.vector(*given(param)) : otherwise;
  };
  if (info.name == "warp") return Transform();  // it moves surfaces by less than its amount
  if (info.name == "translate") {
    const auto by = vector("by", {0, 0, 0});
    return by ? std::optional(Transform::translation(*by)) : std::nullopt;
  }
  if (info.name == "rotate" && given("angle")) {
    const auto angle = values.number(*given("angle"));
    const auto axis = vector("axis", {0, 1, 0}), pivot = vector("pivot", {0, 0, 0});
    if (!angle || !axis || !pivot || !(axis->length() > 0)) return std::nullopt;
    return Transform::translation(*pivot) * Transform::rotation(*axis, *angle) *
           Transform::translation(-*pivot);
  }
  if (info.name == "scale" && given("by")) {
    std::optional<Vec3d> by = values.vector(*given("by"));
    if (const auto factor = values.number(*given("by"))) by = Vec3d(*factor);
    if (!by || !(std::min({by->x, by->y, by->z}) > 0)) return std::nullopt;
    return Transform::scaling(*by);
  }
  return std::nullopt;
}

/// The map of the expressions around a literal, or the reason why it is unknown.
LiteralFrame map_of_chain(const Analysis& analysis, PlainEvaluator& values,
                          const EnclosingChain& chain) {
  Transform place;
  for (const Enclosing& each : chain) {
    if (each.expr->kind != scene::ExprKind::call) continue;
    const auto meaning = kind_of_call(*each.expr, analysis.document, "field");
    if (!meaning) {
      if (std::any_of(analysis.document.defs.begin(), analysis.document.defs.end(),
                      [&](const scene::Def& def) { return def.name == each.expr->text; }))
        return {std::nullopt, fmt::format("the function '{}' places it", each.expr->text)};
      continue;  // a built-in function, such as `if`
    }
    const ParamInfo* param =
        find_param(meaning->info, each.operand, each.expr->operands[each.operand].name);
    if (meaning->info.category != "deformer" || !param || param->type != "field") continue;
    const std::optional<Transform> map = map_of(*each.expr, meaning->info, values);
    if (!map) return {std::nullopt, fmt::format("'{}' around it moves it", each.expr->text)};
    place = place * *map;
  }
  return {place, ""};
}

}  // namespace

bool draws_at_random(const scene::Expr& expr) {
  bool draws = false;
  EnclosingChain chain;
  walk(expr, chain, [&](const scene::Expr& each, const EnclosingChain&) {
    draws = draws || each.kind == scene::ExprKind::range ||
            (each.kind == scene::ExprKind::call && each.text == "pick");
    return !draws;
  });
  return draws;
}

Value PlainEvaluator::value(const scene::Expr& expr) {
  if (draws_at_random(expr)) return {};
  return evaluator_.eval(expr, evaluator_.root());
}

std::optional<double> PlainEvaluator::number(const scene::Expr& expr) {
  const Value found = value(expr);
  const Number* number = found.get<Number>();
  return number ? std::optional(number->value) : std::nullopt;
}

std::optional<Vec3d> PlainEvaluator::vector(const scene::Expr& expr) {
  const Value found = value(expr);
  const Value::Vector* vector = found.get<Value::Vector>();
  return vector ? std::optional(vector->value) : std::nullopt;
}

std::optional<Vec3d> PlainEvaluator::vector(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const scene::ExprPtr expr = scene::parse_expression(text, "default", ignored_);
  return expr ? vector(*expr) : std::nullopt;
}

std::optional<CallMeaning> kind_of_call(const scene::Expr& call, const scene::Document& document,
                                        const std::string& expected) {
  std::vector<CallMeaning> all = meanings_of(open_call(call), document, expected);
  if (all.empty() || all.front().function) return std::nullopt;
  return std::move(all.front());
}

const scene::Expr* operand_for(const scene::Expr& call, const KindInfo& info,
                               const std::string& name) {
  for (size_t i = 0; i < call.operands.size(); ++i)
    if (const ParamInfo* param = find_param(info, i, call.operands[i].name);
        param && param->name == name)
      return call.operands[i].value.get();
  return nullptr;
}

LiteralFrame frame_of(const Analysis& analysis, PlainEvaluator& values, const Statement& statement,
                      const EnclosingChain& chain) {
  if (statement.def) return {std::nullopt, "the calls of the function place it"};
  if (statement.grammar && !chain.empty()) return {std::nullopt, "the rules place it"};
  LiteralFrame own = map_of_chain(analysis, values, chain);
  Statement outer = statement;
  for (int depth = 0; own.place && outer.let && depth < kMostLets; ++depth) {
    const LetUse use = first_use(analysis.document, *outer.let);
    if (!use.statement.known()) break;
    const LiteralFrame around = map_of_chain(analysis, values, use.chain);
    if (!around.place) return around;
    own.place = *around.place * *own.place;
    outer = use.statement;
  }
  return own;
}

}  // namespace vug::language
