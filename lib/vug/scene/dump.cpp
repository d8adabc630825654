// SPDX-License-Identifier: Apache-2.0
// Documents as text in a canonical form, for comparisons in tests.
#include <vug/scene/lsystem_document.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? "\\n" : std::string(1, c);
  }
  return out + '"';
}

std::string number_text(const Number& number) {
  const bool ratio = number.dimension == Dimension::ratio;
  return fmt::format("{}{}", number.value, ratio ? "ratio" : unit_of(number.dimension));
}

void write(const Expr& expr, std::string& out);

void write_parts(const Expr& expr, std::string& out) {
  bool first = true;
  for (const Operand& part : expr.operands) {
    if (!first) out += ", ";
    first = false;
    if (!part.name.empty()) out += part.name + ": ";
    for (const Formal& bound : part.binds) out += bound.name + ' ';
    write(*part.value, out);
  }
}

void write(const Expr& expr, std::string& out) {
  switch (expr.kind) {
    case ExprKind::number:
      out += number_text(expr.number);
      return;
    case ExprKind::text:
      out += quoted(expr.text);
      return;
    case ExprKind::truth:
    case ExprKind::name:
      out += expr.text;
      return;
    case ExprKind::vector:
    case ExprKind::list: {
      const bool vector = expr.kind == ExprKind::vector;
      out += vector ? '(' : '[';
      write_parts(expr, out);
      out += vector ? ')' : ']';
      return;
    }
    case ExprKind::unary:
      out += '(' + expr.text + ' ';
      write(*expr.operands[0].value, out);
      out += ')';
      return;
    case ExprKind::binary:
    case ExprKind::range:
      out += '(';
      write(*expr.operands[0].value, out);
      out += expr.kind == ExprKind::range ? fmt::format(" ..#{:x} ", expr.path)
                                          : ' ' + expr.text + ' ';
      write(*expr.operands[1].value, out);
      out += ')';
      return;
    case ExprKind::index:
      out += "index(";
      write_parts(expr, out);
      out += ')';
      return;
    case ExprKind::comprehension:
      out += fmt::format("[#{:x} ", expr.path);
      write_parts(expr, out);
      out += ']';
      return;
    case ExprKind::broken:
      out += '?';
      return;
    case ExprKind::call:
      out += fmt::format("{}{}#{:x}(", expr.method ? "." : "", expr.text, expr.path);
      write_parts(expr, out);
      out += ')';
      return;
  }
}

std::string dump(const ExprPtr& expr) { return expr ? scene::dump(*expr) : "-"; }

std::string dump(const std::vector<Let>& locals) {
  std::string out;
  for (const Let& local : locals)
    out += fmt::format("    where {} = {}\n", local.name, dump(local.value));
  return out;
}

std::string dump(const Def& def) {
  std::string out = fmt::format("def {} {}\n", def.name, quoted(def.doc));
  for (const Formal& formal : def.formals)
    out += fmt::format("    {} = {} {}\n", formal.name, dump(formal.fallback), quoted(formal.doc));
  return out + fmt::format("    = {}\n", dump(def.body)) + dump(def.locals);
}

std::string dump(const Entry& entry) {
  std::string out = entry.key;
  for (const ExprPtr& value : entry.values) out += ' ' + dump(value);
  return out;
}

std::string dump(const std::vector<Item>& items) {
  std::string out;
  for (const Item& item : items) {
    out += fmt::format("    {} {} {} * {}", item.op.empty() ? "symbol" : item.op, dump(item.amount),
                       dump(item.shape), dump(item.count));
    for (const Entry& clause : item.clauses) out += " | " + dump(clause);
    out += '\n';
  }
  return out;
}

std::string dump(const Grammar& grammar) {
  std::string out = fmt::format("grammar {} : {}\n", grammar.name, grammar.kind);
  out += "  axiom\n" + dump(grammar.axiom);
  for (const Entry& option : grammar.options) out += "  " + dump(option) + '\n';
  for (const Rule& rule : grammar.rules) {
    out += "  rule " + rule.head + '(';
    for (const Formal& formal : rule.formals) out += formal.name + ',';
    out += fmt::format(") @ {} if {}\n", dump(rule.weight), dump(rule.guard));
    out += dump(rule.items) + dump(rule.locals);
  }
  if (grammar.lsystem) out += scene::dump(*grammar.lsystem);
  return out;
}

}  // namespace

std::string dump(const Expr& expr) {
  std::string out;
  write(expr, out);
  return out;
}

std::string dump(const Document& document) {
  std::string out = "seed " + dump(document.seed) + '\n';
  for (const Param& param : document.params)
    out += fmt::format("param {} = {} in {} .. {} {} given {}\n", param.name, dump(param.value),
                       dump(param.low), dump(param.high), quoted(param.doc), dump(param.given));
  for (const Let& let : document.lets)
    out += fmt::format("let {} = {}\n", let.name, dump(let.value));
  for (const Def& def : document.defs) out += dump(def);
  for (const Declaration& made : document.declarations) {
    out +=
        fmt::format("{} {} = {} on {}", made.kind, made.name, dump(made.value), dump(made.target));
    if (made.loop) out += " for " + dump(made.loop);
    for (const ExprPtr& target : made.more_targets) out += ", " + dump(target);
    out += '\n';
    for (const Entry& entry : made.entries) out += "  " + dump(entry) + '\n';
  }
  for (const Grammar& grammar : document.grammars) out += dump(grammar);
  return out;
}

}  // namespace vug::scene
