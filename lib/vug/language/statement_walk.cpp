// SPDX-License-Identifier: Apache-2.0
#include <vug/language/statement_walk.h>

namespace vug::language {
namespace {

bool on_line(const SourceLocation& extent, const std::string& file, int line) {
  return extent.file == file && extent.line <= line && line <= extent.end_line;
}

}  // namespace

void walk(const scene::Expr& expr, EnclosingChain& chain,
          const std::function<bool(const scene::Expr&, const EnclosingChain&)>& visit) {
  if (!visit(expr, chain)) return;
  for (size_t i = 0; i < expr.operands.size(); ++i) {
    if (!expr.operands[i].value) continue;
    chain.push_back({&expr, i});
    walk(*expr.operands[i].value, chain, visit);
    chain.pop_back();
  }
}

const SourceLocation& Statement::extent() const {
  static const SourceLocation unknown;
  return declaration ? declaration->extent
         : let       ? let->extent
         : def       ? def->extent
         : grammar   ? grammar->extent
                     : unknown;
}

Statement statement_at(const scene::Document& document, const std::string& file, int line) {
  Statement out;
  for (const scene::Declaration& each : document.declarations)
    if (on_line(each.extent, file, line)) return out.declaration = &each, out;
  for (const scene::Let& each : document.lets)
    if (on_line(each.extent, file, line)) return out.let = &each, out;
  for (const scene::Def& each : document.defs)
    if (on_line(each.extent, file, line)) return out.def = &each, out;
  for (const scene::Grammar& each : document.grammars)
    if (on_line(each.extent, file, line)) return out.grammar = &each, out;
  return out;
}

LetUse first_use(const scene::Document& document, const scene::Let& let) {
  LetUse found;
  const auto search = [&](const scene::ExprPtr& value, const Statement& statement) {
    if (!value || found.statement.known()) return;
    EnclosingChain chain;
    walk(*value, chain, [&](const scene::Expr& expr, const EnclosingChain& around) {
      if (found.statement.known()) return false;
      if (expr.kind == scene::ExprKind::name && scene::full_name(expr) == let.name)
        found = {statement, around};
      return true;
    });
  };
  for (const scene::Declaration& each : document.declarations) {
    search(each.value, {&each, nullptr, nullptr, nullptr});
    for (const scene::Entry& entry : each.entries)
      for (const scene::ExprPtr& value : entry.values)
        search(value, {&each, nullptr, nullptr, nullptr});
  }
  for (const scene::Let& each : document.lets)
    if (each.name != let.name) search(each.value, {nullptr, &each, nullptr, nullptr});
  return found;
}

}  // namespace vug::language
