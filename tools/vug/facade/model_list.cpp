// SPDX-License-Identifier: Apache-2.0
#include "model_list.h"

#include <fmt/format.h>
#include <vug/modeller/lines.h>
#include <vug/modeller/query.h>

#include <algorithm>

namespace vug::cli {

namespace {

using facade::FreeNumber;
using facade::Reason;
using modeller::FacadeState;
using modeller::RuleChoice;

std::string length(double metres) { return fmt::format("{:.4g}", metres); }

/// "0.1 PartFacade 12 x 6 m at (0, 3), 2 times"
std::string head(const FacadeState& state, int index) {
  const facade::Node& node = state.node(index);
  std::string out = fmt::format("{} {} {} x {} m at ({}, {})", state.path(index), node.text,
                                length(node.rect.width), length(node.rect.height),
                                length(node.rect.x), length(node.rect.y));
  if (!node.copies.empty()) out += fmt::format(", {} times", 1 + node.copies.size());
  if (state.planned(index).mirrored) out += ", turned";
  return out;
}

std::string numbers(const std::vector<FreeNumber>& free) {
  std::string out;
  for (const FreeNumber& number : free) {
    out += fmt::format(" {}=", number.name);
    for (size_t i = 0; i < number.values.size(); ++i)
      out += fmt::format("{}{:.4g}", i ? "," : "", number.values[i]);
  }
  return out;
}

std::string choice_text(const modeller::Style& style, const RuleChoice& choice) {
  const std::string name = style.rule_name(choice.rule);
  if (choice.applied) return fmt::format("  * {}{}\n", name, numbers(choice.free));
  if (choice.reason == Reason::none) return fmt::format("  + {}{}\n", name, numbers(choice.free));
  return fmt::format("  - {} [{}: {}]\n", name, facade::to_string(choice.reason), choice.why);
}

std::string lines_text(const FacadeState& state, int node) {
  std::string out;
  const std::vector<modeller::Line> all = modeller::lines(state, node);
  for (size_t i = 0; i < all.size(); ++i)
    out += fmt::format("{} {} at {} {:.4g}", out.empty() ? "" : ",", i, all[i].upright ? "x" : "y",
                       all[i].at);
  return out.empty() ? "" : fmt::format("  lines:{}\n", out);
}

/// `whole`: lists the other rules of a divided node one by one.
std::string node_text(const FacadeState& state, int node, bool whole) {
  std::string out = head(state, node) + "\n";
  if (state.node(node).element) return out + "  an element\n";
  const std::vector<RuleChoice> all = modeller::choices(state, node);
  if (all.empty() && !state.planned(node).free.empty())
    out += fmt::format("  * within its rule{}\n", numbers(state.planned(node).free));
  const bool divided = state.rule(node) >= 0;
  for (const RuleChoice& choice : all)
    if (!divided || choice.applied || whole) out += choice_text(state.style(), choice);
  if (divided && all.size() > 1 && !whole)
    out += fmt::format("  - {} more of '{}' [{}]\n", all.size() - 1, state.node(node).symbol,
                       facade::to_string(Reason::divided));
  const size_t others = state.style().rules().rules.size() - all.size();
  if (others > 0)
    out += fmt::format("  - {} of other symbols [{}]\n", others,
                       facade::to_string(Reason::wrong_symbol));
  return out + lines_text(state, node);
}

std::string actions_text(const FacadeState& state, int node) {
  std::string out = "actions:\n";
  for (const modeller::ActionChoice& each : modeller::actions(state, node)) {
    const bool enabled = each.choice.reason == Reason::none;
    out += fmt::format("  {} {}{}\n", enabled ? '+' : '-', each.action->name,
                       enabled ? "" : fmt::format(" [{}]", facade::to_string(each.choice.reason)));
  }
  return out;
}

}  // namespace

std::string tree_text(const FacadeState& state) {
  std::string out;
  for (size_t i = 0; i < state.tree().nodes.size(); ++i) {
    const int index = static_cast<int>(i);
    size_t depth = 0;
    for (int at = state.node(index).parent; at >= 0; at = state.node(at).parent) ++depth;
    out += std::string(2 * depth, ' ') + head(state, index);
    if (state.node(index).stuck) out += "  open";
    if (state.rule(index) >= 0) out += "  " + state.style().rule_name(state.rule(index));
    out += numbers(state.planned(index).free) + '\n';
  }
  return out;
}

std::string list_text(const FacadeState& state, const std::string& path) {
  if (path != ".") {
    const int node = state.find(path);
    return node_text(state, node, true) +
           (state.node(node).element ? "" : actions_text(state, node));
  }
  std::string out;
  for (size_t i = 0; i < state.tree().nodes.size(); ++i)
    if (!state.tree().nodes[i].element) out += node_text(state, static_cast<int>(i), false);
  return out;
}

}  // namespace vug::cli
