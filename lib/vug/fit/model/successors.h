// The parameters that a production gives to its parts: drawn, or told.
#pragma once

#include <vug/fit/model/model.h>
#include <vug/fit/search/edge_hints.h>
#include <vug/inference/choices.h>

namespace vug::fit {

/// What moves are made with; shared by all chains.
struct MoveContext {
  const Model& model;
  const EdgeHints& hints;
};

/// A node's parts, and the cells where the node is a grid whose windows differ.
struct Successors {
  std::vector<Node> nodes;
  Cells cells{};
};

/// Those of node i, which has been rewritten.
Successors successors_of(const TreeState& state, int i);

/// Chooses the parts that the production gives to node i, whose area is known. Where `choices`
/// tell, `told` are chosen. False where no parts fit.
bool choose_successors(const MoveContext& context, const TreeState& state, int i, int production,
                       inference::Choices& choices, const Successors& fixed, Successors& out);

/// Chooses where in the area of node i something is that stands by itself, a door or a shop.
void choose_rect(const MoveContext& context, const TreeState& state, int i,
                 inference::Choices& choices, const Node& fixed, Node& out);

/// Rewrites node i into the parts, and takes them away again.
void apply_production(TreeState& state, int i, int production, const Successors& parts);
void undo_production(TreeState& state, int i);

}  // namespace vug::fit
