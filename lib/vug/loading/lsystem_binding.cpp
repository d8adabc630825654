// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/lsystem_binding.h>
#include <vug/lsystem/compile.h>
#include <vug/lsystem/turtle_environment.h>
#include <vug/shot/lsystem_plan.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace vug::loading {
namespace {

/// Whether the entry is a list of bare names, such as `instances leaf, flower`, even if
/// declarations have these names.
bool is_names(const std::string& key) { return key == "instances"; }

/// Appends the value of an expression, or the elements of a list in brackets.
void add_values(const scene::Entry& entry, const scene::Expr& expr, RandomKey key,
                ReadContext& context, List& values) {
  const bool names = is_names(entry.key);
  if (names && expr.kind == scene::ExprKind::list) {
    for (const scene::Operand& part : expr.operands)
      add_values(entry, *part.value, key, context, values);
    return;
  }
  const bool bare = names && expr.kind == scene::ExprKind::name;
  values.push_back(bare ? Value(expr.text) : context.evaluator.eval(expr, key.at(values.size())));
}

Value entry_value(const scene::Entry& entry, const scene::Grammar& grammar, ReadContext& context) {
  const RandomKey key = context.evaluator.root().at("grammar").at(grammar.name).at(entry.key);
  List values;
  for (const scene::ExprPtr& expr : entry.values) add_values(entry, *expr, key, context, values);
  for (const Value& value : values)
    if (value.empty()) return {};
  return values.size() == 1 ? values[0] : Value(std::move(values));
}

/// Binds the block; nothing, with diagnostics, if an entry is invalid.
std::optional<shot::LSystemBlock> block_of(const scene::Grammar& grammar, ReadContext& context) {
  Arguments entries;
  bool sound = true;
  for (const scene::Entry& entry : grammar.options) {
    Value value = entry_value(entry, grammar, context);
    sound = sound && !value.empty();
    entries.push_back({entry.key, std::move(value), entry.extent});
  }
  if (!sound) return std::nullopt;
  std::optional<shot::LSystemBlock> block =
      shot::lsystem_schema().bind(entries, grammar.where, context.diagnostics);
  if (block && !lsystem::check_whole(*block, grammar, context.diagnostics)) block.reset();
  return block;
}

/// Reports unknown queries, for which it returns false, and warns about ?D without a field.
bool check_queries(const scene::LSystem& text, bool has_field, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const lsystem::TurtleQuery& query : lsystem::turtle_queries()) known.push_back(query.name);
  bool sound = true, warned = false;
  const auto check = [&](const auto& modules) {
    for (const auto& module : modules) {
      if (!lsystem::System::is_query(module.name)) continue;
      if (std::find(known.begin(), known.end(), module.name) == known.end()) {
        diagnostics.error(module.where, fmt::format("unknown query '{}'", module.name),
                          fmt::format("known queries: {}", fmt::join(known, ", ")));
        sound = false;
      } else if (module.name == "?D" && !has_field && !std::exchange(warned, true)) {
        diagnostics.warning(module.where,
                            "'?D' queries the distance to the 'field', but the block has none: the "
                            "result is 1e6 m everywhere",
                            "field rock");
      }
    }
  };
  check(text.axiom);
  scene::for_each_production(text, [&](const scene::Production& one) {
    check(one.left);
    check(one.right);
    check(one.word);
  });
  return sound;
}

}  // namespace

Value bind_lsystem(const scene::Grammar& grammar, ReadContext& context) {
  std::optional<shot::LSystemBlock> block = block_of(grammar, context);
  if (grammar.broken || !grammar.lsystem) return {};
  const bool has_field = !block || block->field.has_value();
  const bool sound = check_queries(*grammar.lsystem, has_field, context.diagnostics);
  const lsystem::FindSystem find = [&](const std::string& name,
                                       const SourceLocation& where) -> lsystem::SystemPtr {
    const auto& all = context.document.grammars;
    const bool known = std::any_of(all.begin(), all.end(), [&](const scene::Grammar& other) {
      return other.name == name && other.kind == "lsystem";
    });
    if (!known || name == grammar.name) return nullptr;
    const auto value = context.resolver.declared("grammar", name, where, context.diagnostics);
    const auto* other = value ? value->object<shot::LSystemPtr>() : nullptr;
    return other ? (*other)->system : nullptr;
  };
  const lsystem::SystemPtr system =
      lsystem::compile(grammar, block.value_or(shot::LSystemBlock()), context.evaluator, find);
  if (!system || !block || !sound) return {};
  const auto made = std::make_shared<const shot::LSystemPlan>(
      grammar.name, system, std::move(*block), context.options.max_memory);
  context.shot.lsystems.push_back(made);
  return ValueTraits<shot::LSystemPtr>::write(shot::LSystemPtr(made));
}

}  // namespace vug::loading
