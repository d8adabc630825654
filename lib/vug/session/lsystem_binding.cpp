#include <vug/lsystem/compile.h>
#include <vug/session/lsystem_binding.h>
#include <vug/session/turtle_block.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::session {
namespace {

ParamInfo option(const char* name, const char* type, const char* fallback, const char* doc) {
  ParamInfo info;
  info.name = name;
  info.type = type;
  info.fallback = fallback;
  info.doc = doc;
  return info;
}

bool is_systems(const std::string& key) {
  const std::vector<std::string>& own = lsystem::system_options();
  return std::find(own.begin(), own.end(), key) != own.end();
}

/// A list of bare names, `instances leaf, flower`, whatever is declared under them.
bool is_names(const std::string& key) { return key == "instances"; }

Value entry_value(const scene::Entry& entry, const scene::Grammar& grammar, Reading& reading) {
  const RandomKey key = reading.evaluator.root().at("grammar").at(grammar.name);
  List values;
  for (const scene::ExprPtr& expr : entry.values) {
    const bool bare = is_names(entry.key) && expr->kind == scene::ExprKind::name;
    values.push_back(bare ? Value(expr->text)
                          : reading.evaluator.eval(*expr, key.at(entry.key).at(values.size())));
    if (values.back().empty()) return {};
  }
  return values.size() == 1 ? values[0] : Value(std::move(values));
}

/// The turtle's options; false, with diagnostics, where one is nothing.
bool read_turtle(const scene::Grammar& grammar, Reading& reading, Arguments& out) {
  std::vector<std::string> known;
  for (const ParamInfo& info : lsystem_info().params) known.push_back(info.name);
  bool sound = true;
  for (const scene::Entry& entry : grammar.options) {
    if (is_systems(entry.key)) continue;
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      reading.diagnostics.error(entry.where,
                                fmt::format("an L-system has no option '{}'", entry.key),
                                suggestion(entry.key, known));
      sound = false;
      continue;
    }
    Value value = entry_value(entry, grammar, reading);
    sound = sound && !value.empty();
    out.push_back({entry.key, std::move(value), entry.where});
  }
  return sound;
}

}  // namespace

const KindInfo& lsystem_info() {
  static const KindInfo kind = [] {
    KindInfo info{"lsystem",
                  "declaration",
                  "Words that rules rewrite and a turtle draws: grammar NAME: lsystem { axiom ...  "
                  "MODULE -> MODULES ... }.",
                  "prusinkiewicz1990",
                  {}};
    info.params = {
        option("steps", "whole number", "1", "how often all modules are replaced"),
        option("time", "number", "0", "instead of steps, where modules age"),
        option("limit", "whole number", "10000000", "modules of a word at most"),
        option("seed", "whole number", "", "in place of the scene's"),
    };
    const std::vector<ParamInfo>& turtle = turtle_schema().info().params;
    info.params.insert(info.params.end(), turtle.begin(), turtle.end());
    return info;
  }();
  return kind;
}

Value bind_lsystem(const scene::Grammar& grammar, Reading& reading) {
  LSystemPlan plan;
  plan.name = grammar.name;
  plan.where = grammar.where;
  const bool sound = read_turtle(grammar, reading, plan.turtle);
  if (grammar.broken || !grammar.lsystem) return {};
  const lsystem::FindSystem find = [&](const std::string& name,
                                       const SourceLocation& where) -> lsystem::SystemPtr {
    const auto& all = reading.document.grammars;
    const bool known = std::any_of(all.begin(), all.end(), [&](const scene::Grammar& other) {
      return other.name == name && other.kind == "lsystem";
    });
    if (!known || name == grammar.name) return nullptr;
    const auto value = reading.resolver.declared("grammar", name, where, reading.diagnostics);
    const auto* other = value ? value->object<LSystemPtr>() : nullptr;
    return other ? (*other)->system : nullptr;
  };
  plan.system = lsystem::compile(grammar, reading.evaluator, find);
  if (!plan.system || !sound) return {};
  const std::optional<TurtleBlock> turtle =
      turtle_schema().bind(plan.turtle, grammar.where, reading.diagnostics);
  if (!turtle) return {};
  const LSystemPtr made = std::make_shared<const DrawnSystem>(std::move(plan), *turtle);
  reading.shot.lsystems.push_back(made);
  return ValueTraits<LSystemPtr>::write(made);
}

}  // namespace vug::session
