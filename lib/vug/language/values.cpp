// SPDX-License-Identifier: Apache-2.0
#include <vug/language/values.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/resolver.h>

#include <algorithm>

namespace vug::language {
namespace {

/// Elements of the longest list that is displayed.
constexpr size_t kMaxElements = 8;

bool is_shown(const Value& value) {
  if (value.empty() || value.get<Object>() || value.get<Value::Name>()) return false;
  if (const List* list = value.get<List>())
    return value.element_count() <= kMaxElements &&
           std::all_of(list->begin(), list->end(), is_shown);
  return true;
}

std::string text_of(const Value& value) {
  if (const Number* number = value.get<Number>())
    return quantity_text(number->value, number->dimension);
  return to_string(value);
}

scene::Expr name_expression(const std::string& name) {
  scene::Expr expr;
  expr.kind = scene::ExprKind::name;
  expr.text = name;
  return expr;
}

}  // namespace

std::map<std::string, std::string> values_of(const Analysis& analysis) {
  std::map<std::string, std::string> values;
  scene::Resolver without_objects;
  Diagnostics ignored;
  scene::Evaluator evaluator(analysis.document, without_objects, ignored);
  const auto add = [&](const std::string& name, const Value& value) {
    if (is_shown(value)) values[name] = text_of(value);
  };
  for (const scene::ParamValue& each : evaluator.params()) add(each.param->name, each.value);
  for (const scene::Let& let : analysis.document.lets)
    add(let.name, evaluator.eval(name_expression(let.name), evaluator.root().at(let.name)));
  return values;
}

}  // namespace vug::language
