// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/split.h>
#include <vug/language/kinds.h>
#include <vug/loading/facade_binding.h>
#include <vug/loading/grammar_binding.h>
#include <vug/loading/kind_registry.h>
#include <vug/loading/reader.h>
#include <vug/shot/lsystem_plan.h>

#include <algorithm>
#include <map>

namespace vug::language {
namespace {

std::map<std::string, std::vector<CallableKind>> by_name() {
  std::map<std::string, std::vector<CallableKind>> all;
  for (const CallableKind& kind : callable_kinds()) all[kind.info->name].push_back(kind);
  return all;
}

}  // namespace

const std::vector<CallableKind>& callable_kinds() {
  static const std::vector<CallableKind> all = [] {
    std::vector<CallableKind> kinds;
    for (const loading::KindRegistry& registry : loading::kind_registries())
      for (const loading::RegisteredKind& kind : registry.kinds)
        kinds.push_back({kind.info, registry.type});
    for (const facade::SplitKind* split : facade::splits())
      kinds.push_back({&split->info, "split"});
    return kinds;
  }();
  return all;
}

const std::vector<CallableKind>& callable_kinds(const std::string& name) {
  static const std::map<std::string, std::vector<CallableKind>> all = by_name();
  static const std::vector<CallableKind> none;
  const auto found = all.find(name);
  return found == all.end() ? none : found->second;
}

const KindInfo* find_declaration(const std::string& keyword) {
  if (keyword == "grammar" || keyword == "shape") return &loading::grammar_info();
  if (keyword == "lsystem") return &shot::lsystem_schema().info();
  if (keyword == "facade") return &loading::facade_info();
  const loading::DeclarationKind* kind = loading::find_declaration_kind(keyword);
  return kind ? &kind->info : nullptr;
}

std::vector<std::string> declaration_words() {
  std::vector<std::string> words;
  for (const loading::DeclarationKind* kind : loading::declaration_kinds())
    words.push_back(kind->info.name);
  return words;
}

std::vector<const ParamInfo*> block_params(const std::string& keyword, const std::string& kind) {
  std::vector<const ParamInfo*> params;
  const KindInfo* own = find_declaration(keyword);
  if (!own) return params;
  const CallableKind* chosen = nullptr;
  for (const CallableKind& each : callable_kinds(kind))
    if (each.type == keyword) chosen = &each;
  for (const ParamInfo& param : own->params)
    if (!chosen || param.name == "kind") params.push_back(&param);
  if (chosen)
    for (const ParamInfo& param : chosen->info->params) params.push_back(&param);
  return params;
}

bool has_choice(const ParamInfo& param, const std::string& word) {
  return std::find(param.choices.begin(), param.choices.end(), word) != param.choices.end();
}

}  // namespace vug::language
