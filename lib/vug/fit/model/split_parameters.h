// The parameters that a production gives to its parts: drawn, or told.
#pragma once

#include <vug/fit/search/edge_hints.h>
#include <vug/fit/model/model.h>
#include <vug/inference/choices.h>

namespace vug::fit {

/// What moves are made with; shared by all chains.
struct Workshop {
  const Model& model;
  const Hints& hints;
};

/// A node's parts, and the cells where the node is a grid whose windows differ.
struct Parts {
  std::vector<Node> nodes;
  Cells cells{};
};

/// Those of node i, which has been rewritten.
Parts parts_of(const State& state, int i);

/// Chooses the parts that the production gives to node i, whose area is known. Where `choices`
/// tell, `told` are chosen. False where no parts fit.
bool choose_parts(const Workshop& shop, const State& state, int i, int production,
                  inference::Choices& choices, const Parts& told, Parts& out);

/// Chooses where in the area of node i something is that stands by itself, a door or a shop.
void choose_rect(const Workshop& shop, const State& state, int i, inference::Choices& choices,
                 const Node& told, Node& out);

/// Rewrites node i into the parts, and takes them away again.
void put_parts(State& state, int i, int production, const Parts& parts);
void take_parts(State& state, int i);

}  // namespace vug::fit
