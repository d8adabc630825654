// SPDX-License-Identifier: Apache-2.0
// Calls of the functions that a text defines, and the local names of `where`.
#include <vug/scene/evaluator.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::scene {

KindInfo info_of(const Def& def) {
  KindInfo info{def.name, "function", def.doc, "", {}};
  for (const Formal& formal : def.formals) {
    ParamInfo& param = info.params.emplace_back();
    param.name = formal.name;
    param.required = !formal.fallback;
    param.doc = formal.doc.empty() && param.required ? "it has no default" : formal.doc;
  }
  return info;
}

const Def* Evaluator::find_def(const std::string& name) const {
  const auto found = defs_.find(name);
  return found == defs_.end() ? nullptr : found->second.def;
}

/// Whether the receiver of a method is a module: rocks.slab(...).
bool Evaluator::is_module_call(const Expr& expr) const {
  if (!expr.method) return false;
  const Expr& receiver = *expr.operands[0].value;
  return receiver.kind == ExprKind::name && document_.find_module(full_name(receiver));
}

/// Calls a function of a module.
Value Evaluator::call_member(const Expr& expr, const Context& context) {
  const std::string module = full_name(*expr.operands[0].value) + ".";
  if (const auto def = defs_.find(module + expr.text); def != defs_.end())
    return call_def(def->second, expr, 1, context);
  std::vector<std::string> names;
  for (const auto& [name, def] : defs_)
    if (name.starts_with(module) && name[module.size()] != '_')
      names.push_back(name.substr(module.size()));
  return FaultSite{word_at(expr.where, expr.text), *diagnostics_}.fault(
      fmt::format("the module '{}' has no function '{}'", expr.operands[0].value->text, expr.text),
      suggestion(expr.text, names));
}

/// `first` is the index of the first operand that is an argument.
Value Evaluator::call_def(const DefEntry& entry, const Expr& expr, size_t first,
                          const Context& context) {
  const Def& def = *entry.def;
  called_.insert(def.name);
  if (def.broken || document_.skipped.doubtful.count(def.name)) return {};
  const SourceLocation word = word_at(expr.where, expr.text);
  if (!admit(def.work, "calls of functions", word)) return {};
  std::vector<Binding> given;
  bool complete = true;
  for (size_t i = first; i < expr.operands.size(); ++i) {
    const Operand& part = expr.operands[i];
    given.push_back(measured(part.name, *part.value, {context.key, context.scope, {}}));
    complete = complete && !given.back().value.empty();
  }
  const RandomKey key = context.key.at(expr.path);
  Locals locals(def.locals, key.at("where"));
  Scope scope{{}, nullptr, &locals};
  if (!bind(entry, expr, given, key, scope) || !complete) return {};
  const FrameScope frame(resolver_.frames(), fmt::format("def '{}'", def.name), word);
  Diagnostics found;
  Diagnostics* const outer = std::exchange(diagnostics_, &found);
  Value value = evaluate(*def.body, {key, &scope, context.expected});
  diagnostics_ = outer;
  for (Diagnostic one : found.all()) {
    if (!reported_in_defs_.insert(fmt::format("{} {}", to_string(one.where), one.message)).second)
      continue;
    one.message += fmt::format(", in the call of '{}' at {}", def.name, to_string(word));
    diagnostics_->add(std::move(one));
  }
  return value;
}

/// Adds the parameters to the scope. Each default sees the parameters before it.
bool Evaluator::bind(const DefEntry& entry, const Expr& expr, std::vector<Binding>& given,
                     RandomKey key, Scope& scope) {
  const Def& def = *entry.def;
  Arguments arguments;
  for (size_t i = 0; i < given.size(); ++i)
    arguments.push_back({given[i].name, given[i].value,
                         expr.operands[expr.operands.size() - given.size() + i].where});
  Diagnostics found;
  const std::vector<int> slots =
      detail::match_arguments(entry.info, arguments, word_at(expr.where, expr.text), found);
  report(found, arguments);
  if (found.has_errors()) return false;
  bool sound = true;
  for (size_t slot = 0; slot < def.formals.size(); ++slot) {
    const Formal& formal = def.formals[slot];
    Binding bound(formal.name, {});
    if (formal.fallback)
      bound =
          measured(formal.name, *formal.fallback, {key.at("default").at(formal.name), &scope, {}});
    const auto at = std::find(slots.begin(), slots.end(), static_cast<int>(slot));
    if (at != slots.end()) {
      const auto index = static_cast<size_t>(at - slots.begin());
      Value& value = given[index].value;
      if (formal.fallback && !value.empty())
        value = match_type(bound.value, std::move(value),
                           fmt::format("argument '{}' of '{}'", formal.name, def.name),
                           arguments[index].where);
      bound = Binding(formal.name, std::move(value), given[index].height);
    }
    sound = sound && !bound.value.empty();
    scope.names.push_back(std::move(bound));
  }
  return sound;
}

/// The value of an expression with the nesting depth of the calls that made it.
Binding Evaluator::measured(const std::string& name, const Expr& expr, const Context& context) {
  const int deepest = std::exchange(deepest_, depth_);
  Value value = evaluate(expr, context);
  const bool nested = value.get<Object>() || value.get<List>();
  const int height = nested ? deepest_ - depth_ : 0;
  deepest_ = deepest;
  return {name, std::move(value), height};
}

/// The value of a local name; nothing if no scope has it.
std::optional<Value> Evaluator::find_local(const Expr& expr, const Scope* scope) {
  for (; scope; scope = scope->outer) {
    for (const Binding& bound : scope->names)
      if (bound.name == expr.text) return use(bound.value, bound.height, expr.where);
    if (!scope->locals) continue;
    for (const Let& let : scope->locals->lets)
      if (let.name == expr.text) return local(let, *scope, expr.where);
  }
  return std::nullopt;
}

Value Evaluator::local(const Let& let, const Scope& scope, const SourceLocation& where) {
  Locals& locals = *scope.locals;
  auto known = locals.values.find(let.name);
  if (known == locals.values.end()) {
    if (is_cyclic(locals.pending, let.name, where)) return {};
    locals.pending.push_back(let.name);
    Binding made = measured(let.name, *let.value, {locals.key.at(let.name), &scope, {}});
    locals.pending.pop_back();
    known = locals.values.emplace(let.name, std::move(made)).first;
  }
  return use(known->second.value, known->second.height, where);
}

}  // namespace vug::scene
