// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/style.h>
#include <vug/scene/evaluator.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace vug::modeller {

namespace {

using facade::Item;
using facade::ItemKind;
using facade::Rule;

std::string right_side(const Rule& rule) {
  return facade::to_string(rule).substr(rule.head.size() + 4);
}

/// The name before the brackets.
std::string first_word(const std::string& text) { return text.substr(0, text.find_first_of("( ")); }

bool only_elements(const std::vector<Item>& items) {
  return std::all_of(items.begin(), items.end(), [](const Item& item) {
    return item.kind == ItemKind::element || item.kind == ItemKind::value ||
           (item.kind == ItemKind::split && only_elements(item.parts));
  });
}

/// The common part of an action's rules: the split and its first part, or the whole right side.
std::string common(const Rule& rule) {
  if (rule.items.size() != 1 || rule.items[0].kind != ItemKind::split ||
      rule.items[0].parts.empty())
    return right_side(rule);
  return rule.items[0].name + '/' + rule.items[0].parts[0].name;
}

void throw_first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& one : diagnostics.all())
    if (one.severity == Severity::error)
      throw Error(ErrorCode::bad_input, one.message, one.where, one.hint);
}

}  // namespace

StylePtr Style::make(scene::Document document, const std::string& grammar,
                     std::shared_ptr<scene::Resolver> resolver) {
  if (!resolver) resolver = std::make_shared<scene::Resolver>();
  const std::shared_ptr<Style> made(new Style(std::move(document), std::move(resolver)));
  made->read(grammar);
  made->collect_actions();
  return made;
}

void Style::read(const std::string& grammar) {
  const scene::Grammar* found = nullptr;
  std::vector<std::string> names;
  for (const scene::Grammar& each : document_.grammars) {
    if (each.kind != "facade") continue;
    names.push_back(each.name);
    if (grammar.empty() || each.name == grammar) found = &each;
  }
  if (names.empty())
    throw Error(ErrorCode::bad_input, "no grammar of kind facade", {},
                "write 'grammar NAME: facade { ... }'");
  if (!found)
    throw Error(ErrorCode::bad_input, fmt::format("unknown facade '{}'", grammar), {},
                suggestion(grammar, names));
  if (grammar.empty() && names.size() > 1)
    throw Error(ErrorCode::bad_input,
                fmt::format("there are several facades: {}", fmt::join(names, ", ")), {},
                "select one of them");
  Diagnostics diagnostics;
  rules_ = facade::read_rules(document_, *found, diagnostics);
  throw_first_error(diagnostics);
  if (found->broken)
    throw Error(ErrorCode::bad_input, fmt::format("the facade '{}' has errors", found->name),
                found->where);
  read_size(*found);
}

void Style::read_size(const scene::Grammar& grammar) {
  Diagnostics diagnostics;
  scene::Evaluator evaluator(document_, *resolver_, diagnostics);
  for (const scene::Entry& entry : grammar.options) {
    if (entry.key != "width" && entry.key != "height") continue;
    const std::vector<Value> values =
        evaluator.eval(entry, evaluator.root().at("grammar").at(grammar.name));
    const Number* number = values.size() == 1 ? values[0].get<Number>() : nullptr;
    if (number && number->value > 0) (entry.key == "width" ? width_ : height_) = number->value;
  }
  throw_first_error(diagnostics);
}

std::vector<int> Style::rules_of(const std::string& symbol) const {
  std::vector<int> out;
  for (size_t i = 0; i < rules_.rules.size(); ++i)
    if (rules_.rules[i].head == symbol) out.push_back(static_cast<int>(i));
  return out;
}

std::string Style::rule_name(int index) const {
  const std::string text = right_side(rule(index));
  const std::vector<int> all = rules_of(rule(index).head);
  int alike = 0, number = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    alike += right_side(rule(all[i])) == text;
    if (all[i] == index) number = static_cast<int>(i) + 1;
  }
  return alike > 1 ? fmt::format("{} #{}", text, number) : text;
}

int Style::find_rule(const std::string& symbol, const std::string& called) const {
  const std::vector<int> all = rules_of(symbol);
  std::vector<std::string> names;
  std::vector<int> begin_so;
  for (size_t i = 0; i < all.size(); ++i) {
    names.push_back(rule_name(all[i]));
    const std::string& name = names.back();
    if (called == name || called == symbol + " -> " + name || called == fmt::format("#{}", i + 1))
      return all[i];
    if (first_word(name) == called) begin_so.push_back(all[i]);
  }
  if (begin_so.size() == 1) return begin_so[0];
  if (all.empty())
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is not divided by any rule", symbol));
  if (begin_so.size() > 1) {
    names.clear();
    for (const int each : begin_so) names.push_back(rule_name(each));
    throw Error(ErrorCode::bad_input,
                fmt::format("several rules of '{}' begin with '{}'", symbol, called), {},
                fmt::format("one of: {}", fmt::join(names, ", ")));
  }
  std::vector<std::string> words;
  for (const std::string& name : names) words.push_back(first_word(name));
  const std::string known = fmt::format("its rules: {}", fmt::join(names, ", "));
  throw Error(ErrorCode::bad_input, fmt::format("'{}' has no rule '{}'", symbol, called), {},
              did_you_mean(called, names, did_you_mean(called, words, known)));
}

bool Style::ends_in_elements(const std::string& symbol) const {
  const std::vector<int> all = rules_of(symbol);
  return !all.empty() && std::all_of(all.begin(), all.end(),
                                     [&](int index) { return only_elements(rule(index).items); });
}

std::optional<std::string> Style::passes_to(int index) const {
  const std::vector<Item>& items = rule(index).items;
  if (items.size() != 1 || items[0].kind != ItemKind::symbol) return std::nullopt;
  return items[0].name;
}

void Style::collect_actions() {
  std::vector<std::string> keys;
  for (size_t i = 0; i < rules_.rules.size(); ++i) {
    const Rule& rule = rules_.rules[i];
    if (ends_in_elements(rule.head) && rule.head != rules_.axiom.at(0).name) continue;
    const std::string key = common(rule);
    const auto at = static_cast<size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
    if (at == keys.size()) {
      keys.push_back(key);
      actions_.push_back({right_side(rule), {}});
    }
    actions_[at].rules.push_back(static_cast<int>(i));
  }
}

facade::PlannedDerivation Style::derive(const facade::DeriveOptions& options,
                                        const facade::PlanOptions& planning) const {
  Diagnostics diagnostics;
  scene::Evaluator evaluator(document_, *resolver_, diagnostics);
  std::optional<facade::PlannedDerivation> made =
      facade::derive(rules_, evaluator, options, planning);
  throw_first_error(diagnostics);
  if (!made) throw Error(ErrorCode::internal, "a derivation failed without a reason");
  return std::move(*made);
}

}  // namespace vug::modeller
