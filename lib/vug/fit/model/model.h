// What is asked of a tree: whether it is one, where its areas lie, and how many bits it costs.
#pragma once

#include <vug/fit/likelihood.h>
#include <vug/fit/model/tree_state.h>

#include <functional>

namespace vug::fit {

/// A rectangle of a picture in pixels, its top row being 0: x0 <= x < x1, y0 <= y < y1.
struct Rect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool operator==(const Rect&) const = default;
};

inline bool overlap(const Rect& a, const Rect& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// Where a terminal stands in its area.
inline Rect rect_of(const Node& node) {
  return {node.x, node.y, node.x + node.width, node.y + node.height};
}

/// Rules, limits and evidence; all the same for all chains.
class Model {
 public:
  /// What is referred to must outlive the model. `evidence` and `likelihood` may be null: then
  /// pixels cost nothing, which leaves the prior. Bits of pixels count `trust` each: neighbours are
  /// no independent witnesses, so that codes which take them for such make too much of them.
  Model(const Rules& rules, const Limits& limits, int width, int height,
        const Evidence* evidence = nullptr, LikelihoodPtr likelihood = nullptr,
        double pixel_weight = 1);

  const Rules& rules() const { return *rules_; }
  const Limits& limits() const { return limits_; }
  int width() const { return width_; }
  int height() const { return height_; }
  const Likelihood* likelihood() const { return likelihood_.get(); }
  double pixel_weight() const { return pixel_weight_; }

  /// The axiom alone.
  TreeState axiom_state() const {
    return make_state({{Node{.symbol = static_cast<int16_t>(rules_->axiom)}}});
  }
  TreeState make_state(Tree tree) const;

  /// Places the areas. False where the tree is none: something does not fit into its area, is
  /// smaller than the least, overlaps, or is more than the limits allow.
  bool compute_areas(TreeState& state) const;
  /// Whether the parameters of node i and its terminal parts fit into its area.
  bool fits(const TreeState& state, int i) const;

  /// Bits of the tree and its pixels; computes what is not known.
  double energy(TreeState& state) const;
  /// c(T): bits of the nodes' symbols and parameters alone. An element in which nothing stands
  /// costs as much as one with something: being left out is no description.
  double complexity(const Tree& tree) const;
  double complexity(const Tree& tree, int i) const;
  /// Bits of the pixels that node i answers for, in full.
  double pixel_bits(const TreeState& state, int i) const;

  /// Whether the node is a window of a grid, whose lines say where it stands.
  bool in_grid(const Node& node) const {
    return static_cast<Op>(node.parent_op) == Op::windows &&
           rules_->symbol(node.symbol).type == RegionType::window;
  }

  /// Calls visit(look, node, rect) for everything that is seen, in the picture: windows, doors.
  /// The node is the terminal.
  void each_terminal(const TreeState& state,
                     const std::function<void(RegionType, int, const Rect&)>& visit) const;

  /// Calls visit(part, rect) for each window of grid i, with the index of the window's node and its
  /// rectangle in the grid's area; none where its door is.
  void each_window(const Tree& tree, int i,
                   const std::function<void(int, const Rect&)>& visit) const;

  /// In the picture, of a rectangle of an area in one of its places.
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
  std::vector<bool> elements_;  ///< Of each symbol: whether it only becomes terminals.
  int x_bits_, y_bits_;
};

/// What the evidence counts in a rectangle of an area, over all places of the area.
Sums sum_of(const Evidence& evidence, const TreeState& state, const Area& area, const Rect& r);
/// The same of all of the area.
Sums sum_of(const Evidence& evidence, const TreeState& state, const Area& area);

/// Where a part begins that stands side by side `times` times in a room of that width, for the time
/// `again` from 0; its own width is room / times, so that a pixel may be left over between two.
inline int repetition_offset(int room, int times, int again) { return again * room / times; }

/// How far to the right windows of a grid may reach. At the border of a part that comes again they
/// would touch themselves: one window, told as two.
inline int usable_width(const Area& area) { return area.width - (area.count > 1 ? 1 : 0); }

/// Bits that count `range` values.
int bits_for(int range);

}  // namespace vug::fit
