// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/selection.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::workbench {
namespace {

using modeller::FacadeState;

int sibling(const FacadeState& state, int node, std::ptrdiff_t step) {
  const std::vector<int> all = state.parts(state.node(node).parent);
  const auto at = std::find(all.begin(), all.end(), node) - all.begin() + step;
  return at < 0 || at >= static_cast<std::ptrdiff_t>(all.size()) ? node
                                                                 : all[static_cast<size_t>(at)];
}

int next_open(const FacadeState& state, int node) {
  const std::vector<int> open = state.open();
  if (open.empty()) return node;
  const auto next = std::upper_bound(open.begin(), open.end(), node);
  return next == open.end() ? open.front() : *next;
}

}  // namespace

int Selection::node(const FacadeState& state) const {
  for (std::vector<facade::PartKey> keys = keys_; !keys.empty(); keys.pop_back())
    if (const int found = state.at(keys); found != FacadeState::kWhole) return found;
  return state.tree().nodes.empty() ? FacadeState::kWhole : 0;
}

void Selection::set(const FacadeState& state, int node) { keys_ = state.path_keys(node); }

int relative(const FacadeState& state, int node, const std::string& which) {
  if (node == FacadeState::kWhole) return node;
  const std::vector<int> parts = state.parts(node);
  if (which == "parent") return std::max(0, state.node(node).parent);
  if (which == "child") return parts.empty() ? node : parts.front();
  if (which == "next") return sibling(state, node, 1);
  if (which == "previous") return sibling(state, node, -1);
  if (which == "open") return next_open(state, node);
  throw Error(ErrorCode::bad_input, fmt::format("unknown relative '{}' of a node", which), {},
              "one of: parent, child, next, previous, open");
}

}  // namespace vug::workbench
