// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/loading/item_clauses.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

/// A clause with its value.
struct Given {
  const scene::Entry& entry;
  const RuleValues& values;
  Value value;

  /// Reports an unsuitable value unless `fits`.
  void expect(bool fits, const char* what) const {
    const auto* number = value.get<Number>();
    if (!fits)
      values.fail(entry.extent, fmt::format("'{}' expects {}, not {}", entry.key, what,
                                            number ? to_string(value) : value.type_name()));
  }
  /// A number of that dimension in a range.
  double number(Dimension dimension, double low, double high, const char* what) const {
    const auto* n = value.get<Number>();
    const bool fits = n && (n->dimension == dimension || is_plain(n->dimension)) &&
                      n->value >= low && n->value <= high;
    expect(fits, what);
    return n->value;
  }
};

sgm::Label label(const Given& given) {
  const auto* name = given.value.get<Value::Name>();
  given.expect(name != nullptr, "a direction such as +X, or random");
  const auto found = sgm::label_from(name->text);
  if (!found)
    given.values.fail(given.entry.extent, fmt::format("unknown label '{}'", name->text),
                      suggestion(name->text, sgm::label_names()));
  return *found;
}

sgm::Reach reach(const Given& given) {
  const auto* name = given.value.get<Value::Name>();
  const bool local = name && name->text == "local";
  given.expect(local || (name && name->text == "whole"), "local or whole");
  return local ? sgm::Reach::local : sgm::Reach::whole;
}

/// The azimuths of joints: one angle or a list of them.
std::vector<double> azimuths(const Given& given) {
  constexpr const char* kWhat = "an angle such as 35deg, or a list of them";
  std::vector<double> out;
  const auto add = [&](const Value& value) {
    out.push_back(
        Given{given.entry, given.values, value}.number(Dimension::angle, -2 * kPi, 2 * kPi, kWhat));
  };
  if (const auto* list = given.value.get<List>())
    for (const Value& each : *list) add(each);
  else
    add(given.value);
  given.expect(!out.empty(), kWhat);
  return out;
}

struct Clause {
  const char* name;
  bool about_gluing;
  void (*read)(const Given& given, ItemClauses& out);
};

constexpr Clause kClauses[] = {
    {"label", true, [](const Given& g, ItemClauses& out) { out.step.label = label(g); }},
    {"blend", false,
     [](const Given& g, ItemClauses& out) {
       const auto blend = ValueTraits<field::Blend>::read(g.value);
       g.expect(blend.has_value(), "a blend such as smooth(10cm)");
       out.step.blend = *blend;
     }},
    {"overlap", true,
     [](const Given& g, ItemClauses& out) {
       out.step.overlap = g.number(Dimension::ratio, 0, 1, "a share between 0% and 100%");
     }},
    {"reach", false, [](const Given& g, ItemClauses& out) { out.step.reach = reach(g); }},
    {"pieces", false,
     [](const Given& g, ItemClauses& out) {
       constexpr const char* kWhat = "a whole number between 0 and 1000";
       const double count = g.number(Dimension::none, 0, 1000, kWhat);
       g.expect(count == std::floor(count), kWhat);
       out.pieces = std::max(1, static_cast<int>(count));
     }},
    {"piece_label", false,
     [](const Given& g, ItemClauses& out) { out.step.piece_label = label(g); }},
    {"slope", true,
     [](const Given& g, ItemClauses& out) {
       out.step.heading.slope =
           g.number(Dimension::angle, -kPi / 2, kPi / 2, "an angle between -90deg and 90deg");
     }},
    {"azimuth", true,
     [](const Given& g, ItemClauses& out) { out.step.heading.azimuths = azimuths(g); }},
    {"within", true,
     [](const Given& g, ItemClauses& out) {
       const auto* solid = g.value.object<field::Field>();
       g.expect(solid != nullptr, "a solid");
       out.step.limits.within = *solid;
     }},
    {"apart", true,
     [](const Given& g, ItemClauses& out) {
       out.step.limits.apart = g.number(Dimension::length, 0, kInfinity, "a length of at least 0");
     }},
    {"name", false,
     [](const Given& g, ItemClauses& out) {
       const auto* text = g.value.get<std::string>();
       g.expect(text && !text->empty(), "a text such as \"hall\"");
       out.step.name = *text;
     }},
};

/// The choice in a clause, such as +X or random, even if X or random is declared.
std::optional<std::string> choice(const std::string& key, const scene::Expr& expr) {
  std::string word = expr.text;
  if (expr.kind == scene::ExprKind::unary && expr.operands[0].value->kind == scene::ExprKind::name)
    word += expr.operands[0].value->text;
  else if (expr.kind != scene::ExprKind::name)
    return std::nullopt;
  const bool label = (key == "label" || key == "piece_label") && sgm::label_from(word);
  const bool reach = key == "reach" && (word == "local" || word == "whole");
  return label || reach ? std::optional(word) : std::nullopt;
}

const Clause* find_clause(const std::string& name) {
  const auto* found = std::find_if(std::begin(kClauses), std::end(kClauses),
                                   [&](const Clause& clause) { return clause.name == name; });
  return found == std::end(kClauses) ? nullptr : found;
}

}  // namespace

const std::vector<std::string>& clause_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Clause& clause : kClauses) all.emplace_back(clause.name);
    return all;
  }();
  return names;
}

bool is_about_gluing(const std::string& clause) {
  const Clause* found = find_clause(clause);
  return found && found->about_gluing;
}

void read_clause(const scene::Entry& clause, RandomKey key, const scene::Scope& scope,
                 const RuleValues& values, ItemClauses& out) {
  const Clause* found = find_clause(clause.key);
  if (!found)
    values.fail(clause.where, fmt::format("unknown clause '{}'", clause.key),
                suggestion(clause.key, clause_names()));
  const scene::Expr& expr = *clause.values.at(0);
  const std::optional<std::string> word = choice(clause.key, expr);
  found->read({clause, values,
               word ? Value(Value::Name{*word}) : values.value(expr, key.at(clause.key), scope)},
              out);
}

}  // namespace vug::loading
