// A facade while it is modelled: what has been decided so far, and the tree that it comes to.
#pragma once

#include <vug/modeller/style.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace vug::modeller {

/// What the facade is drawn on. Metres.
struct Canvas {
  double width = 12, height = 9;
  double min_size = 0.05;  ///< No part may be narrower or lower.
  uint64_t seed = 0;       ///< Of what rules draw in their arguments; choices are never drawn.
  /// Symbols at most; more is Error(too_large).
  int64_t max_symbols = 100'000;
};

/// An immutable value; copies are cheap. Nodes are numbers in the tree, and change from state to
/// state; paths are what stays.
///
/// A path names a node by its way from the facade: "0.1.2" by numbers among the parts as they stand
/// in the tree, or by names, "Facade.PartFacade.Grid.window[2,1]": [k] is the part of that name
/// with number k, [column,row] the one at this place of a split that counts so. "." is the facade
/// itself, which only has the numbers of splits in the axiom.
class FacadeState {
 public:
  /// Nothing but the axiom. Error(bad_input) for sizes that are not above 0.
  FacadeState(StylePtr style, const Canvas& canvas);

  const Style& style() const { return *inner_->style; }
  const StylePtr& style_ptr() const { return inner_->style; }
  const Canvas& canvas() const { return inner_->canvas; }
  /// Symbols that no rule divides yet are stuck in it.
  const facade::Tree& tree() const { return inner_->tree; }
  const facade::Plan& plan() const { return inner_->plan; }
  const facade::Node& node(int index) const {
    return inner_->tree.nodes.at(static_cast<size_t>(index));
  }
  /// Of the facade itself for kWhole.
  const facade::PlannedNode& planned(int index) const;
  /// What is decided of the node; an empty plan where nothing is.
  const facade::Plan& plan_of_node(int index) const;
  /// The rule that divides the node; below 0: none.
  int rule(int index) const { return plan_of_node(index).rule; }
  std::vector<int> open() const;  ///< Nodes that no rule divides yet.

  static constexpr int kWhole = -1;
  /// The node of a path. Error(bad_input) that says how far the way goes.
  int find(const std::string& path) const;
  std::string path(int index) const;  ///< In numbers.

  /// The places on the way from the facade to the node, and back; kWhole for a way that nothing
  /// stands at the end of.
  std::vector<facade::PartKey> path_keys(int index) const;
  int at(const std::vector<facade::PartKey>& keys) const;
  /// Nodes whose parent it is.
  std::vector<int> parts(int index) const;

  /// The state in which something else is decided of the node; null: nothing. Errors as of
  /// Style::derive, and then nothing has changed.
  FacadeState with(int index, facade::PlanPtr plan) const;
  FacadeState with(facade::Plan whole) const;
  /// The plan of the facade in which only the way to the node is decided, and it as `plan` says.
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
