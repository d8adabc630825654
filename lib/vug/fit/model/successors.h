// SPDX-License-Identifier: Apache-2.0
// Parameters of the nodes that a production creates: sampled, or scored for fixed values.
#pragma once

#include <vug/fit/model/model.h>
#include <vug/fit/search/edge_hints.h>
#include <vug/inference/choices.h>

#include <optional>

namespace vug::fit {

/// What moves work with; shared by all chains.
struct MoveContext {
  const Model& model;
  const EdgeHints& hints;
};

/// The child nodes that a production creates, and the cells of a grid whose windows differ.
struct Successors {
  std::vector<Node> nodes;
  Cells cells{};
};

/// The successors of node i, which has been rewritten.
Successors successors_of(const TreeState& state, int i);

/// Chooses the successors that the production gives to node i, whose area is valid. If `choices`
/// score instead of sampling, `fixed` is chosen. Nothing if no successors fit.
std::optional<Successors> choose_successors(const MoveContext& context, const TreeState& state,
                                            int i, int production, inference::Choices& choices,
                                            const Successors& fixed);

/// Chooses the rectangle of a free-standing element, a door or a shop, in the area of node i.
void choose_rect(const MoveContext& context, const TreeState& state, int i,
                 inference::Choices& choices, const Node& fixed, Node& out);

/// Rewrites node i with a production into the successors, and reverts that.
void apply_production(TreeState& state, int i, int production, const Successors& parts);
void undo_production(TreeState& state, int i);

}  // namespace vug::fit
