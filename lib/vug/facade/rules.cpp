// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/rules.h>
#include <vug/scene/inline_locals.h>
#include <vug/scene/parser.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace vug::facade {
namespace {

class Reader {
 public:
  Reader(const scene::Document& document, const scene::Grammar& grammar, Diagnostics& diagnostics)
      : grammar_(grammar), diagnostics_(diagnostics) {
    for (const scene::Param& param : document.params) values_.insert(param.name);
    for (const scene::Let& let : document.lets) values_.insert(let.name);
    for (const scene::Rule& rule : grammar.rules) arities_[rule.head].insert(rule.formals.size());
    for (const std::string& head : grammar.broken_rules) broken_.insert(head);
    skipped_ = document.skipped;
  }

  Rules read() {
    Rules out;
    out.name = grammar_.name;
    out.where = grammar_.where;
    const scene::LocalInliner none({});
    for (const scene::Item& each : grammar_.axiom) add(each, none, out.axiom);
    for (const scene::Rule& rule : grammar_.rules) {
      const scene::LocalInliner inlined(rule.locals);
      Rule made{rule.head, {}, rule.extent, inlined(rule.weight), inlined(rule.guard), {}};
      for (const scene::Formal& formal : rule.formals) made.formals.push_back(formal.name);
      formals_ = {made.formals.begin(), made.formals.end()};
      // The names of a faulty rule may expand without end.
      if (!grammar_.broken || rule.locals.empty())
        for (const scene::Item& each : rule.items) add(each, inlined, made.items);
      formals_.clear();
      out.rules.push_back(std::move(made));
    }
    return out;
  }

 private:
  void add(const scene::Item& source, const scene::LocalInliner& inlined, std::vector<Item>& out) {
    if (!source.op.empty() || source.amount || source.count || !source.clauses.empty()) {
      diagnostics_.error(source.where,
                         "the rules of a facade can only contain symbols, splits and elements",
                         "combine solids with + - & outside of the grammar");
      return;
    }
    Item item;
    item.position = out.size();
    if (read(inlined(source.shape), item, true)) out.push_back(std::move(item));
  }

  /// Classifies the expression as an item; returns false if it is not one. With `must`, unknown
  /// names are reported.
  bool read(const scene::ExprPtr& expr, Item& item, bool must) {
    const bool call = expr->kind == scene::ExprKind::call && !expr->method;
    if (!call && expr->kind != scene::ExprKind::name) {
      if (must) diagnostics_.error(expr->where, "expected a symbol, a split or an element");
      return false;
    }
    item.name = expr->text;
    item.where = expr->where;
    item.expr = expr;
    if (const auto known = arities_.find(expr->text); known != arities_.end()) {
      item.kind = ItemKind::symbol;
      check_arity(*expr, known->second);
      return true;
    }
    if (broken_.count(expr->text)) return true;
    if (!call && (formals_.count(expr->text) || values_.count(full_name(*expr)))) {
      item.kind = ItemKind::value;
      return true;
    }
    if ((item.element = find_kind(elements(), expr->text))) {
      item.kind = ItemKind::element;
      return true;
    }
    if ((item.split = find_kind(splits(), expr->text))) {
      item.kind = ItemKind::split;
      return parts(*expr, item);
    }
    if (must) unknown(*expr);
    return false;
  }

  bool parts(const scene::Expr& call, Item& item) {
    if (call.kind != scene::ExprKind::call) {
      diagnostics_.error(call.where, fmt::format("'{}' has no parts", call.text),
                         fmt::format("write {}(...)", call.text));
      return false;
    }
    for (size_t i = 0; i < call.operands.size(); ++i) {
      const scene::ExprPtr& value = call.operands[i].value;
      Item part;
      part.position = i;
      const bool name = value->kind == scene::ExprKind::name;
      const bool must = name && !is_word(value->text) && !is_choice(*item.split, value->text);
      if (read(value, part, must)) item.parts.push_back(std::move(part));
    }
    return true;
  }

  /// Names that always denote numbers.
  static bool is_word(const std::string& name) {
    static const std::set<std::string> words = {"width", "height", "index", "total", "pi", "frame"};
    return words.count(name) > 0;
  }
  static bool is_choice(const SplitKind& kind, const std::string& name) {
    for (const ParamInfo& param : kind.info.params)
      if (std::find(param.choices.begin(), param.choices.end(), name) != param.choices.end())
        return true;
    return false;
  }

  void check_arity(const scene::Expr& use, const std::set<size_t>& takes) {
    const size_t given = use.kind == scene::ExprKind::call ? use.operands.size() : 0;
    if (takes.count(given)) return;
    std::string text;
    for (const size_t count : takes) text += fmt::format("{}{}", text.empty() ? "" : " or ", count);
    diagnostics_.error(
        use.where, fmt::format("'{}' has {} argument{}", use.text, given, given == 1 ? "" : "s"),
        fmt::format("its rules take {}", text));
  }

  void unknown(const scene::Expr& expr) {
    if (skipped_.may_declare(expr.text)) return;
    std::vector<std::string> names(formals_.begin(), formals_.end());
    for (const auto& [head, arity] : arities_) names.push_back(head);
    for (const ElementKind* kind : elements()) names.push_back(kind->info.name);
    for (const SplitKind* kind : splits()) names.push_back(kind->info.name);
    diagnostics_.error(
        expr.where,
        fmt::format("'{}' is neither a symbol with a rule nor a split nor an element", expr.text),
        did_you_mean(expr.text, names, "'vug list split' and 'vug list element' list them"));
  }

  const scene::Grammar& grammar_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::set<size_t>> arities_;
  std::set<std::string> values_, formals_, broken_;
  scene::SkippedNames skipped_;
};

std::string to_string(const Item& item) {
  std::string out = item.name;
  if (item.kind != ItemKind::split) return out;
  out += '(';
  for (size_t i = 0; i < item.parts.size(); ++i)
    out += (i == 0 ? "" : ", ") + to_string(item.parts[i]);
  return out + ')';
}

void collect(const std::vector<Item>& items, std::vector<std::string>& out) {
  for (const Item& item : items) {
    if (item.kind == ItemKind::element && std::find(out.begin(), out.end(), item.name) == out.end())
      out.push_back(item.name);
    collect(item.parts, out);
  }
}

}  // namespace

std::vector<std::string> Rules::symbols() const {
  std::vector<std::string> out;
  for (const Rule& rule : rules)
    if (std::find(out.begin(), out.end(), rule.head) == out.end()) out.push_back(rule.head);
  collect(axiom, out);
  for (const Rule& rule : rules) collect(rule.items, out);
  return out;
}

std::string to_string(const Rule& rule) {
  std::string out = rule.head + " ->";
  for (const Item& item : rule.items) out += ' ' + to_string(item);
  return rule.items.empty() ? out + " nothing" : out;
}

Rules read_rules(const scene::Document& document, const scene::Grammar& grammar,
                 Diagnostics& diagnostics) {
  return Reader(document, grammar, diagnostics).read();
}

Rules load_rules(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  const scene::Document document = scene::parse_file(file, diagnostics);
  const scene::Grammar* found = nullptr;
  for (const scene::Grammar& grammar : document.grammars)
    if (grammar.kind == "facade") {
      if (found)
        throw Error(ErrorCode::bad_input, "the file has several grammars of kind facade",
                    grammar.where);
      found = &grammar;
    }
  if (!found && !diagnostics.has_errors())
    throw Error(ErrorCode::bad_input, "the file has no grammar of kind facade", {file.string()},
                "write 'grammar NAME: facade { ... }'");
  Rules rules;
  if (found) rules = read_rules(document, *found, diagnostics);
  for (const Diagnostic& one : diagnostics.all())
    if (one.severity == Severity::error)
      throw Error(ErrorCode::bad_input, one.message, one.where, one.hint);
  return rules;
}

}  // namespace vug::facade
