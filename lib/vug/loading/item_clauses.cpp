// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/loading/item_clauses.h>
#include <vug/loading/option_info.h>

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
    if (!fits)
      values.fail(entry.extent,
                  fmt::format("'{}' expects {}, not {}", entry.key, what, description()));
  }
  /// The value as in messages: numbers in the units of texts, other values by their types.
  std::string description() const {
    if (const auto* number = value.get<Number>()) return shortest_text(*number);
    if (const auto* text = value.get<std::string>(); text && text->empty()) return "an empty text";
    if (const auto* list = value.get<List>(); list && list->empty()) return "an empty list";
    return value.type_name();
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

ParamInfo overlap_info() {
  ParamInfo info =
      option_info("overlap", "number",
                  "penetration of a shape as a fraction of its extent; default: by its operation");
  info.min = 0;
  info.max = 1;
  info.dimension = Dimension::ratio;
  return info;
}

/// The names of two places.
std::pair<std::string, std::string> two_names(const Given& given) {
  constexpr const char* kWhat = "the names of two places, such as [\"hall\", \"lake\"]";
  const auto names = ValueTraits<std::vector<std::string>>::read(given.value);
  given.expect(names && names->size() == 2 && !names->front().empty() && !names->back().empty(),
               kWhat);
  return {names->front(), names->back()};
}

/// The shapes that a clause has an effect on.
enum class Applies {
  to_all,
  when_glued,  ///< Not on shapes that are placed on a network or connect two places.
};

struct Clause {
  ParamInfo info;
  Applies applies;
  void (*read)(const Given& given, ItemClauses& out);
};

const std::vector<Clause>& clauses() {
  static const std::vector<Clause> all = {
      {choice_info("label", sgm::label_names(), "random", "side to which a shape is attached"),
       Applies::when_glued, [](const Given& g, ItemClauses& out) { out.step.label = label(g); }},
      {option_info("blend", "blend", "blend between a shape and the existing solid"),
       Applies::to_all,
       [](const Given& g, ItemClauses& out) {
         const auto blend = ValueTraits<field::Blend>::read(g.value);
         g.expect(blend.has_value(), "a blend such as smooth(10cm)");
         out.step.blend = *blend;
       }},
      {overlap_info(), Applies::when_glued,
       [](const Given& g, ItemClauses& out) {
         out.step.overlap = g.number(Dimension::ratio, 0, 1, "a share between 0% and 100%");
       }},
      {choice_info("reach", {"local", "whole"}, "local", "range of the effect of a shape"),
       Applies::to_all, [](const Given& g, ItemClauses& out) { out.step.reach = reach(g); }},
      {whole_info("pieces", 0, 1000, "1",
                  "number of shapes joined before they are attached; 0 counts as 1"),
       Applies::to_all,
       [](const Given& g, ItemClauses& out) {
         constexpr const char* kWhat = "a whole number between 0 and 1000";
         const double count = g.number(Dimension::none, 0, 1000, kWhat);
         g.expect(count == std::floor(count), kWhat);
         out.pieces = std::max(1, static_cast<int>(count));
       }},
      {choice_info("piece_label", sgm::label_names(), "random",
                   "side to which each piece is attached"),
       Applies::to_all, [](const Given& g, ItemClauses& out) { out.step.piece_label = label(g); }},
      {option_info("slope", "angle",
                   "inclination of the direction in which a shape continues the solid"),
       Applies::when_glued,
       [](const Given& g, ItemClauses& out) {
         out.step.heading.slope =
             g.number(Dimension::angle, -kPi / 2, kPi / 2, "an angle between -90deg and 90deg");
       }},
      {option_info("azimuth", "angle or list",
                   "compass directions of joints, of which a shape follows the nearest"),
       Applies::when_glued,
       [](const Given& g, ItemClauses& out) { out.step.heading.azimuths = azimuths(g); }},
      {option_info("within", "field", "solid that must contain the middle of each shape"),
       Applies::to_all,
       [](const Given& g, ItemClauses& out) {
         const auto* solid = g.value.object<field::Field>();
         g.expect(solid != nullptr, "a solid");
         out.step.limits.within = *solid;
       }},
      {option_info("apart", "length", "least distance to shapes that are not neighbours"),
       Applies::to_all,
       [](const Given& g, ItemClauses& out) {
         out.step.limits.apart =
             g.number(Dimension::length, 0, kInfinity, "a length of at least 0");
       }},
      {option_info("name", "text", "name of the place of a shape, for locator(...)"),
       Applies::to_all,
       [](const Given& g, ItemClauses& out) {
         const auto* text = g.value.get<std::string>();
         g.expect(text && !text->empty(), "a text such as \"hall\"");
         out.step.name = *text;
       }},
      {option_info(kConnectClause, "list of texts",
                   "names of two places between which a shape extends; only after a shape"),
       Applies::to_all, [](const Given& g, ItemClauses& out) { out.step.connect = two_names(g); }},
  };
  return all;
}

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
  const auto found = std::find_if(clauses().begin(), clauses().end(),
                                  [&](const Clause& clause) { return clause.info.name == name; });
  return found == clauses().end() ? nullptr : &*found;
}

}  // namespace

std::vector<ParamInfo> clause_infos() {
  std::vector<ParamInfo> infos;
  for (const Clause& clause : clauses()) infos.push_back(clause.info);
  return infos;
}

bool is_clause(const std::string& name) { return find_clause(name) != nullptr; }

bool applies_without_glue(const std::string& clause) {
  const Clause* found = find_clause(clause);
  return !found || found->applies == Applies::to_all;
}

void read_clause(const scene::Entry& clause, RandomKey key, const scene::Scope& scope,
                 const RuleValues& values, ItemClauses& out) {
  const Clause* found = find_clause(clause.key);
  if (!found) {
    std::vector<std::string> names;
    for (const Clause& one : clauses()) names.push_back(one.info.name);
    values.fail(clause.where, fmt::format("unknown clause '{}'", clause.key),
                suggestion(clause.key, names));
  }
  const scene::Expr& expr = *clause.values.at(0);
  const std::optional<std::string> word = choice(clause.key, expr);
  found->read({clause, values,
               word ? Value(Value::Name{*word}) : values.value(expr, key.at(clause.key), scope)},
              out);
}

}  // namespace vug::loading
