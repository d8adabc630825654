// SPDX-License-Identifier: Apache-2.0
// The state of a facade being modelled: the decisions so far and the resulting tree.
#pragma once

#include <vug/modeller/style.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace vug::modeller {

/// Size and derivation settings of the facade. Lengths in metres.
struct Canvas {
  double width = 12, height = 9;
  double min_size = 0.05;  ///< Smallest width and height of a part.
  uint64_t seed = 0;       ///< Seed of random numbers in rule arguments; choices are never random.
  /// Maximum number of symbols; Error(too_large) beyond it.
  int64_t max_symbols = 100'000;
};

/// An immutable value with cheap copies. Node indices change from state to state; paths are stable.
///
/// A path leads from the facade to a node. It is written with child indices, "0.1.2", or with
/// names, "Facade.PartFacade.Grid.window[2,1]": [k] is the child number k of that name,
/// [column,row] the child at that position of a split with columns and rows. "." is the facade
/// itself, which only has the numbers of splits in the axiom.
class FacadeState {
 public:
  /// A state with the axiom only. Error(bad_input) for sizes that are not above 0.
  FacadeState(StylePtr style, const Canvas& canvas);

  const Style& style() const { return *inner_->style; }
  const StylePtr& style_ptr() const { return inner_->style; }
  const Canvas& canvas() const { return inner_->canvas; }
  /// Contains undivided symbols as stuck nodes.
  const facade::Tree& tree() const { return inner_->tree; }
  const facade::Plan& plan() const { return inner_->plan; }
  const facade::Node& node(int index) const {
    return inner_->tree.nodes.at(static_cast<size_t>(index));
  }
  /// kWhole refers to the facade itself.
  const facade::PlannedNode& planned(int index) const;
  /// The decisions about the node; an empty plan without any.
  const facade::Plan& plan_of_node(int index) const;
  /// The rule that divides the node; below 0 if none does.
  int rule(int index) const { return plan_of_node(index).rule; }
  std::vector<int> open() const;  ///< Nodes that no rule divides yet.

  static constexpr int kWhole = -1;
  /// The node of a path. Error(bad_input) reports how far the path could be followed.
  int find(const std::string& path) const;
  std::string path(int index) const;  ///< With child indices.

  /// Converts between a node and the part keys on the path to it; kWhole for a path without a node.
  std::vector<facade::PartKey> path_keys(int index) const;
  int at(const std::vector<facade::PartKey>& keys) const;
  /// Children of the node.
  std::vector<int> parts(int index) const;

  /// The state with another plan for the node; null removes the plan. Throws as Style::derive; this
  /// state is not modified.
  FacadeState with(int index, facade::PlanPtr plan) const;
  FacadeState with(facade::Plan whole) const;
  /// A plan of the facade that only contains the path to the node, with `plan` at its end.
  facade::Plan isolated_plan(int index, facade::PlanPtr plan) const;

 private:
  struct Inner {
    StylePtr style;
    Canvas canvas;
    facade::Plan plan;
    facade::Tree tree;
    facade::PlannedNode root;
    std::vector<facade::PlannedNode> nodes;
  };
  FacadeState(StylePtr style, const Canvas& canvas, facade::Plan plan);

  std::shared_ptr<const Inner> inner_;
};

}  // namespace vug::modeller
