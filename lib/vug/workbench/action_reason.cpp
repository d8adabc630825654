// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/action_reason.h>

#include <fmt/format.h>

namespace vug::workbench {

std::string reason_text(const modeller::RuleChoice& choice) {
  if (choice.reason == facade::Reason::none) return "";
  std::string out = fmt::format("Not available, {}: {}.", facade::to_string(choice.reason),
                                choice.why.empty() ? "no reason is known" : choice.why);
  if (!choice.hint.empty()) out += fmt::format(" Remedy: {}.", choice.hint);
  return out;
}

std::string first_word(const std::string& name) { return name.substr(0, name.find_first_of("( ")); }

modeller::Edit action_edit(const modeller::FacadeState& state, int node,
                           const modeller::Action& action) {
  return {"act", state.path(node), action.name, {}};
}

}  // namespace vug::workbench
