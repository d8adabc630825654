// SPDX-License-Identifier: Apache-2.0
#include <vug/language/inlay_hints.h>
#include <vug/language/values.h>

#include <algorithm>

namespace vug::language {
namespace {

/// Whether the expression is its own value, e.g. 3cm or (1, 2, 3).
bool is_literal(const scene::Expr& expr) {
  if (expr.kind == scene::ExprKind::number || expr.kind == scene::ExprKind::text ||
      expr.kind == scene::ExprKind::truth)
    return true;
  const bool parts = expr.kind == scene::ExprKind::vector || expr.kind == scene::ExprKind::list ||
                     expr.kind == scene::ExprKind::unary;
  return parts && std::all_of(expr.operands.begin(), expr.operands.end(),
                              [](const scene::Operand& part) { return is_literal(*part.value); });
}

}  // namespace

std::vector<Hint> inlay_hints(const Analysis& analysis, int first_line, int last_line) {
  std::vector<Hint> hints;
  const std::map<std::string, std::string> values = values_of(analysis);
  const auto add = [&](const std::string& name, const scene::ExprPtr& value) {
    if (!value || value->extent.file != analysis.file || value->extent.end_line < first_line ||
        value->extent.end_line > last_line || is_literal(*value))
      return;
    if (const auto found = values.find(name); found != values.end())
      hints.push_back({end_of(value->extent), " = " + found->second, "the value of " + name});
  };
  for (const scene::Param& param : analysis.document.params) add(param.name, param.value);
  for (const scene::Let& let : analysis.document.lets) add(let.name, let.value);
  std::sort(hints.begin(), hints.end(),
            [](const Hint& a, const Hint& b) { return a.position < b.position; });
  return hints;
}

}  // namespace vug::language
