// SPDX-License-Identifier: Apache-2.0
// The model of facade trees: validity, layout of the areas, and code length in bits.
#pragma once

#include <vug/fit/likelihood.h>
#include <vug/fit/model/tree_state.h>

#include <functional>

namespace vug::fit {

/// A rectangle of a picture in pixels, row 0 being the top row: x0 <= x < x1, y0 <= y < y1.
struct Rect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool operator==(const Rect&) const = default;
};

inline bool overlap(const Rect& a, const Rect& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// Rectangle of a terminal in its area.
inline Rect rect_of(const Node& node) {
  return {node.x, node.y, node.x + node.width, node.y + node.height};
}

/// What pixels contribute to the energy of a tree. The pointers may be null: pixels then cost
/// nothing, which leaves the prior.
struct PixelTerm {
  const Evidence* evidence = nullptr;  ///< Must outlive the model.
  LikelihoodPtr likelihood = nullptr;
  /// Scales the bits of pixels, because codes that treat neighbouring pixels as independent
  /// overrate them.
  double weight = 1;
};

/// Rules, limits and evidence, shared by all chains.
class Model {
 public:
  /// The rules must outlive the model; width and height in pixels.
  Model(const Rules& rules, const Limits& limits, int width, int height, PixelTerm pixels = {});

  const Rules& rules() const { return *rules_; }
  const Limits& limits() const { return limits_; }
  int width() const { return width_; }
  int height() const { return height_; }
  const Likelihood* likelihood() const { return likelihood_.get(); }
  double pixel_weight() const { return pixel_weight_; }

  /// The state that holds only the axiom.
  TreeState axiom_state() const {
    return make_state({{Node{.symbol = static_cast<int16_t>(rules_->axiom)}}});
  }
  TreeState make_state(Tree tree) const;

  /// Computes the areas. False if the tree is invalid: an element does not fit into its area, is
  /// smaller than the minimum, overlaps another, or a limit is exceeded.
  bool compute_areas(TreeState& state) const;
  /// Whether the parameters of node i and its terminal children fit into its area.
  bool fits(const TreeState& state, int i) const;

  /// Whether an element of that type may have the rectangle, which is relative to the area: doors
  /// and shops are on the ground, and doors have a limited height.
  bool admits(RegionType type, const Area& area, const Rect& rect) const;

  /// Bits of the tree and its pixels; recomputes invalidated values. Infinite for an invalid tree.
  double energy(TreeState& state) const;
  /// c(T): bits of the nodes' symbols and parameters alone. An empty element costs as much as one
  /// with content, since leaving the content out is not a shorter description.
  double complexity(const Tree& tree) const;
  double complexity(const Tree& tree, int i) const;
  /// Unweighted bits of the pixels that node i accounts for.
  double pixel_bits(const TreeState& state, int i) const;

  /// Whether the node is a window of a grid, positioned by the grid's lines.
  bool in_grid(const Node& node) const {
    return static_cast<Op>(node.parent_op) == Op::windows &&
           rules_->symbol(node.symbol).type == RegionType::window;
  }

  /// Calls visit(type, node, rect) for every visible instance of a terminal (window, door, ...), in
  /// picture coordinates. The node is the terminal.
  void each_terminal(const TreeState& state,
                     const std::function<void(RegionType, int, const Rect&)>& visit) const;

  /// Calls visit(node, rect) for each window of grid i with the window's node and its rectangle in
  /// the grid's area; windows covered by the door are skipped.
  void each_window(const Tree& tree, int i,
                   const std::function<void(int, const Rect&)>& visit) const;

  /// Maps a rectangle of an area to the picture for one of the area's instances.
  static Rect in_picture(const Area& area, const AreaInstance& instance, int x, int y, int width,
                         int height) {
    const int left = instance.mirrored ? instance.x + area.width - x - width : instance.x + x;
    return {left, area.y + y, left + width, area.y + y + height};
  }

 private:
  bool compute_child_areas(TreeState& state, int i) const;

  const Rules* rules_;
  Limits limits_;
  int width_, height_;
  const Evidence* evidence_;
  LikelihoodPtr likelihood_;
  double pixel_weight_;
  double symbol_bits_;
  std::vector<bool> elements_;  ///< For each symbol: whether all its productions are terminals.
  int x_bits_, y_bits_;
};

/// Evidence sums over a rectangle of an area, over all instances of the area.
Sums sum_of(const Evidence& evidence, const TreeState& state, const Area& area, const Rect& r);
/// Evidence sums over the whole area.
Sums sum_of(const Evidence& evidence, const TreeState& state, const Area& area);

/// Start of repetition `again` (from 0) of a part that is repeated `times` times over an extent of
/// `room`. The part's width is room / times, so a pixel may be left over between two repetitions.
inline int repetition_offset(int room, int times, int again) { return again * room / times; }

/// Extent that windows of a grid may use along x. In a repeated part the last column of pixels
/// stays free, because windows at the border would touch their own copies and appear as one.
inline int usable_width(const Area& area) { return area.width - (area.count > 1 ? 1 : 0); }

/// Bits needed to encode `range` values.
int bits_for(int range);

}  // namespace vug::fit
