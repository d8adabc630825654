// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/loading/example.h>
#include <vug/loading/kind_params.h>
#include <vug/loading/kit_functions.h>
#include <vug/loading/reader.h>
#include <vug/loading/resolver.h>
#include <vug/shot/networks.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::loading {
ValidArguments::ValidArguments(const Arguments& given) {
  bool placed = true;  // the positions after a lost argument are unknown
  for (const Argument& each : given) {
    if (each.value.empty()) {
      complete = false;
      placed = placed && !each.name.empty();
    } else if (placed || !each.name.empty()) {
      arguments.push_back(each);
    }
  }
}

void ValidArguments::report(const Diagnostics& found, const SourceLocation& where,
                            Diagnostics& diagnostics) const {
  for (const Diagnostic& one : found.all()) {
    if (complete || one.where != where) diagnostics.add(one);
  }
}

void Resolver::declare(const std::string& kind, const std::string& name, Factory factory) {
  std::vector<Entry>& entries = entries_[name];
  for (Entry& entry : entries)
    if (entry.kind == kind) return entry.factories.push_back(std::move(factory));
  entries.push_back({kind, {std::move(factory)}, {}, false, false, false});
}

Value Resolver::value(Entry& entry, const std::string& name, const SourceLocation& where,
                      Diagnostics& diagnostics) {
  record_use(scene::DeclarationName(entry.kind, name));
  if (entry.pending) {
    diagnostics.error(where, fmt::format("'{}' depends on itself", name));
    return Value();
  }
  if (!entry.evaluated && pending_ >= kMaxPending) {
    diagnostics.error(where,
                      fmt::format("more than {} names depend on each other in a row", kMaxPending));
    return Value();
  }
  if (!entry.evaluated) {
    entry.pending = true;
    ++pending_;
    const uint64_t uses = frame_uses();
    const scene::FrameScope frame(frames(), fmt::format("{} '{}'", entry.kind, name), where);
    for (const Factory& factory : entry.factories) entry.value = factory();
    if (entry.factories.size() > 1) entry.value = Value();
    entry.pending = false;
    --pending_;
    entry.evaluated = true;
    entry.frame_dependent = frame_uses() > uses;
  } else if (entry.frame_dependent) {
    use_frame();
  }
  return entry.value;
}

std::optional<Value> Resolver::declared(const std::string& kind, const std::string& name,
                                        const SourceLocation& where, Diagnostics& diagnostics) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return std::nullopt;
  for (Entry& entry : found->second)
    if (entry.kind == kind) return value(entry, name, where, diagnostics);
  return std::nullopt;
}

std::optional<Value> Resolver::name(const std::string& name, const SourceLocation& where,
                                    Diagnostics& diagnostics) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return std::nullopt;
  for (Entry& entry : found->second)
    if (!entry.pending) return value(entry, name, where, diagnostics);
  return value(found->second.front(), name, where, diagnostics);
}

std::optional<Value> Resolver::make(const KindRegistry& registry, const std::string& name,
                                    const Arguments& arguments, const SourceLocation& where,
                                    Diagnostics& diagnostics) {
  const RegisteredKind* kind = registry.find(name);
  if (!kind) return std::nullopt;
  const ValidArguments valid(arguments);
  Diagnostics found;
  Value made;
  try {
    if (auto value = kind->make(valid.arguments, where, found); value && valid.complete)
      made = *value;
  } catch (const Error& error) {
    found.add(error, where);
  }
  valid.report(found, where, diagnostics);
  record(made, where);
  return made;
}

void Resolver::record(const Value& value, const SourceLocation& where) {
  if (const auto* made = value.object<field::Field>())
    provenance_.record(made->node(), {where, frames()});
  if (const auto* network = value.object<shot::NetworkPtr>(); network && *network)
    provenance_.record_files((*network)->files);
}

namespace {

/// Whether the kind has parameters for all named arguments.
bool accepts(const KindInfo& kind, const Arguments& arguments) {
  return std::all_of(arguments.begin(), arguments.end(), [&](const Argument& given) {
    return given.name.empty() || find_param(kind, 0, given.name);
  });
}

/// The registry of a kind whose name several may have: that of the expected type, else the first
/// one whose parameters fit, else the first one; null if there is none.
const KindRegistry* choose_registry(const std::string& name, const Arguments& arguments,
                                    std::string_view expected) {
  const KindRegistry* first = nullptr;
  const KindRegistry* fitting = nullptr;
  for (const KindRegistry& registry : kind_registries()) {
    const RegisteredKind* kind = registry.find(name);
    if (!kind) continue;
    if (registry.type == expected) return &registry;
    if (!first) first = &registry;
    if (!fitting && accepts(*kind->info, arguments)) fitting = &registry;
  }
  return fitting ? fitting : first;
}

}  // namespace

std::optional<Value> Resolver::call(const std::string& name, const Arguments& arguments,
                                    const SourceLocation& where, const CallContext& context,
                                    Diagnostics& diagnostics) {
  const KindRegistry* registry = choose_registry(name, arguments, context.expected);
  return registry ? make(*registry, name, arguments, where, diagnostics) : std::nullopt;
}

std::string_view Resolver::expected_type(const std::string& call, size_t position,
                                         const std::string& argument) const {
  for (const KindRegistry& registry : kind_registries()) {
    const RegisteredKind* kind = registry.find(call);
    if (!kind) continue;
    const ParamInfo* param = find_param(*kind->info, position, argument);
    if (!param) continue;
    return element_type(param->type);
  }
  return {};
}

bool Resolver::is_choice(const std::string& call, size_t position, const std::string& argument,
                         const std::string& word) const {
  for (const KindRegistry& registry : kind_registries()) {
    const RegisteredKind* kind = registry.find(call);
    if (!kind) continue;
    const ParamInfo* param = find_param(*kind->info, position, argument);
    if (param && has_choice(*kind->info, param->name, word)) return true;
  }
  return false;
}

namespace {

/// The choices of all parameters of kinds and declarations, and the names of all kinds.
std::set<std::string> all_words() {
  std::set<std::string> words = {"random", "local", "whole", "none"};
  const auto add = [&](const KindInfo& kind) {
    words.insert(kind.name);
    for (const ParamInfo& param : kind.params)
      words.insert(param.choices.begin(), param.choices.end());
  };
  for (const KindRegistry& registry : kind_registries())
    for (const RegisteredKind& kind : registry.kinds) add(*kind.info);
  for (const DeclarationKind* kind : declaration_kinds()) add(kind->info);
  return words;
}

}  // namespace

bool Resolver::is_word(const std::string& word) const {
  static const std::set<std::string> words = all_words();
  return words.count(word) > 0;
}

std::optional<Value> Resolver::binary(char op, const Value& a, const Value& b,
                                      const SourceLocation& where, Diagnostics& diagnostics) {
  const auto* f = a.object<field::Field>();
  const auto* g = b.object<field::Field>();
  if (f && g && (op == '+' || op == '-' || op == '&')) {
    const Value made = field::as_value(op == '+'   ? field::unite({*f, *g})
                                       : op == '-' ? field::subtract(*f, {*g})
                                                   : field::intersect({*f, *g}));
    record(made, where);
    return made;
  }
  diagnostics.error(
      where, fmt::format("'{}' cannot combine {} and {}", op, a.type_name(), b.type_name()),
      f && g ? "operators of fields: + (union), - (difference) and & (intersection)" : "");
  return Value();
}

std::optional<Value> Resolver::unary(char op, const Value& a, const SourceLocation& where,
                                     Diagnostics& diagnostics) {
  const auto* f = a.object<field::Field>();
  if (f && op == '-') {
    const Value made = field::as_value(field::complement(*f));
    record(made, where);
    return made;
  }
  diagnostics.error(where, fmt::format("'{}' cannot be applied to {}", op, a.type_name()));
  return Value();
}

std::vector<std::string> Resolver::known_names() const {
  std::vector<std::string> names;
  for (const auto& [name, entries] : entries_) names.push_back(name);
  return names;
}

std::vector<std::string> Resolver::known_calls() const {
  std::vector<std::string> names;
  for (const KindRegistry& registry : kind_registries())
    for (const RegisteredKind& kind : registry.kinds) names.push_back(kind.info->name);
  return names;
}

std::string Resolver::call_for(const std::string& word) const {
  for (const KindRegistry& registry : kind_registries())
    for (const RegisteredKind& kind : registry.kinds)
      if (is_synonym(word, *kind.info)) return kind.info->name;
  return "";
}

std::string Resolver::include_with(const std::string& function) const {
  return kit_file_of(function);
}

}  // namespace vug::loading
