// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/step_name.h>

#include <fmt/format.h>

#include <cctype>

namespace vug::workbench {
namespace {

std::string capitalized(std::string word) {
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

}  // namespace

std::string step_name(const modeller::FacadeState& state, const modeller::Edit& edit) {
  const int node = state.find(edit.node);
  const std::string symbol =
      node == modeller::FacadeState::kWhole ? "the facade" : state.node(node).symbol;
  if (edit.kind == "apply" || edit.kind == "act")
    return fmt::format("Apply {} to {}", edit.rule, symbol);
  if (edit.kind == "change") return fmt::format("Change {} to {}", symbol, edit.rule);
  if (edit.kind == "move" && edit.numbers.count("line"))
    return fmt::format("Move line {} of {}", edit.numbers.at("line").at(0), symbol);
  if (edit.kind == "set" && edit.numbers.size() == 1)
    return fmt::format("Set {} of {}", edit.numbers.begin()->first, symbol);
  return fmt::format("{} {}", capitalized(edit.kind), symbol);
}

}  // namespace vug::workbench
