#include <vug/lsystem/compile.h>
#include <vug/session/lsystem_binding.h>
#include <vug/session/lsystem_plan.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::session {
namespace {

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

/// Nothing, with diagnostics, where an entry is at fault.
std::optional<LSystemBlock> block_of(const scene::Grammar& grammar, Reading& reading) {
  Arguments entries;
  bool sound = true;
  for (const scene::Entry& entry : grammar.options) {
    Value value = entry_value(entry, grammar, reading);
    sound = sound && !value.empty();
    entries.push_back({entry.key, std::move(value), entry.where});
  }
  if (!sound) return std::nullopt;
  return lsystem_schema().bind(entries, grammar.where, reading.diagnostics);
}

}  // namespace

Value bind_lsystem(const scene::Grammar& grammar, Reading& reading) {
  std::optional<LSystemBlock> block = block_of(grammar, reading);
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
  const lsystem::SystemPtr system =
      lsystem::compile(grammar, block.value_or(LSystemBlock()), reading.evaluator, find);
  if (!system || !block) return {};
  const auto made = std::make_shared<const LSystemPlan>(grammar.name, system, std::move(*block));
  reading.shot.lsystems.push_back(made);
  return ValueTraits<LSystemPtr>::write(LSystemPtr(made));
}

}  // namespace vug::session
