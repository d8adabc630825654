// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/rule_values.h>

#include <fmt/format.h>

namespace vug::loading {

RuleScope::RuleScope(const scene::Rule& rule, const grammar::RewriteSite& site,
                     const std::vector<size_t>* order)
    : locals_(rule.locals, site.node_key.at("where")) {
  for (size_t i = 0; i < rule.formals.size(); ++i)
    scope_.names.emplace_back(rule.formals[i].name,
                              site.symbol.content.params.at(order ? order->at(i) : i));
  scope_.locals = &locals_;
}

Value RuleValues::value(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) const {
  Value result = evaluator_.eval(expr, key, &scope);
  if (result.empty()) throw AlreadyReported{};
  return result;
}

double RuleValues::number(const scene::Expr& expr, RandomKey key, const scene::Scope& scope) const {
  const Value result = value(expr, key, scope);
  const Number* n = result.get<Number>();
  if (!n) fail(expr.where, fmt::format("a number is needed here, not {}", result.type_name()));
  return n->value;
}

void RuleValues::fail(const SourceLocation& where, const std::string& message,
                      const std::string& hint) const {
  diagnostics_.error(where, message, hint);
  throw AlreadyReported{};
}

void RuleValues::add_context(size_t first, const std::string& doing) const {
  Diagnostics out;
  for (size_t i = 0; i < diagnostics_.all().size(); ++i) {
    Diagnostic one = diagnostics_.all()[i];
    if (i >= first) one.message += ", while " + doing;
    out.add(std::move(one));
  }
  diagnostics_ = std::move(out);
}

}  // namespace vug::loading
