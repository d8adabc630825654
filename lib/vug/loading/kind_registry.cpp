// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/kind_registry.h>
#include <vug/loading/plugin_kinds.h>
#include <vug/loading/scene_families.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace vug::loading {

bool has_choice(const KindInfo& kind, const std::string& parameter, const std::string& word) {
  for (const ParamInfo& info : kind.params)
    if (info.name == parameter)
      return std::find(info.choices.begin(), info.choices.end(), word) != info.choices.end();
  return false;
}

const RegisteredKind* KindRegistry::find(const std::string& name) const {
  for (const RegisteredKind& kind : kinds)
    if (kind.info->name == name) return &kind;
  return nullptr;
}

namespace {

std::vector<KindRegistry>& own_registries() {
  static std::vector<KindRegistry> all = scene_families();
  return all;
}

std::atomic<bool> asked_for = false;

}  // namespace

const std::vector<KindRegistry>& kind_registries() {
  asked_for = true;
  return own_registries();
}

void add_kinds(const std::vector<std::pair<std::string, RegisteredKind>>& kinds) {
  if (asked_for)
    throw Error(ErrorCode::bad_input, "is loaded too late: kinds are already in use", {},
                "load plugins before the first scene");
  std::vector<KindRegistry> all = own_registries();
  for (const auto& [type, kind] : kinds) {
    const std::string& wanted = type;  // clang 14 cannot capture structured bindings
    const auto registry = std::find_if(
        all.begin(), all.end(), [&](const KindRegistry& each) { return each.type == wanted; });
    if (registry == all.end())
      throw Error(ErrorCode::bad_input,
                  fmt::format("provides a {}, which scenes do not support", type));
    if (registry->find(kind.info->name))
      throw Error(ErrorCode::bad_input,
                  fmt::format("provides a {} '{}', which already exists", type, kind.info->name));
    registry->kinds.push_back(kind);
  }
  own_registries() = std::move(all);
}

const KindRegistry* find_registry(const std::string& type) {
  for (const KindRegistry& registry : kind_registries())
    if (registry.type == type) return &registry;
  return nullptr;
}

}  // namespace vug::loading
