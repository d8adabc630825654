// SPDX-License-Identifier: Apache-2.0
// Figure 5 of the paper: models of one facade ordered by complexity. Two of them have one split and
// differ by a bit, like 0.15 and 0.16 in the paper: a middle has a width, a ground floor a height,
// and the picture is slightly higher than wide.
#include <vug/fit/model/compile.h>
#include <vug/fit/model/model.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::fit {
namespace {

constexpr int kFigureWidth = 500, kFigureHeight = 700;

/// Grows trees of the published grammar by symbol names.
class Figure5 : public ::testing::Test {
 protected:
  Figure5()
      : rules_(compile(facade::load_rules(VUG_DATA "/facades/ripperda.vug"))),
        model_(rules_, {}, kFigureWidth, kFigureHeight),
        tree_(model_.axiom_state().tree) {}

  /// The production of `head` with exactly these parts; fails the test without one.
  int production(const std::string& head, const std::vector<std::string>& parts) const {
    for (size_t i = 0; i < rules_.productions.size(); ++i) {
      const Production& each = rules_.productions[i];
      bool same = rules_.symbol(each.head).name == head && each.parts.size() == parts.size();
      for (size_t k = 0; same && k < parts.size(); ++k)
        same = rules_.symbol(each.parts[k]).name == parts[k];
      if (same) return static_cast<int>(i);
    }
    ADD_FAILURE() << "no such rule for " << head;
    return 0;
  }

  /// Rewrites node i; `given` holds the numbers of the parts.
  void rewrite(int i, const std::vector<std::string>& parts, std::vector<Node> given) {
    const int id = production(rules_.symbol(tree_[i].symbol).name, parts);
    const Production& rule = rules_.production(id);
    for (size_t k = 0; k < given.size(); ++k) {
      given[k].symbol = static_cast<int16_t>(rule.parts[std::min(k, rule.parts.size() - 1)]);
      given[k].parent_op = static_cast<int8_t>(rule.op);
    }
    tree_.grow(i, id, given);
  }
  /// The first node with that symbol at index `from` or later.
  int find(const std::string& symbol, int from = 0) const {
    for (int i = from; i < tree_.size(); ++i)
      if (rules_.symbol(tree_[i].symbol).name == symbol) return i;
    ADD_FAILURE() << "no " << symbol;
    return 0;
  }

  static Node extent(int pixels) {
    Node node;
    node.extent = static_cast<int16_t>(pixels);
    return node;
  }
  static Node lines(int columns, int rows, int from_x, int step_x, int from_y, int step_y) {
    Node node;
    node.columns = static_cast<int16_t>(columns), node.rows = static_cast<int16_t>(rows);
    for (int i = 0; i < columns; ++i)
      node.left[static_cast<size_t>(i)] = static_cast<int16_t>(from_x + i * step_x);
    for (int i = 0; i < rows; ++i)
      node.top[static_cast<size_t>(i)] = static_cast<int16_t>(from_y + i * step_y);
    return node;
  }
  static Node window() {
    Node node;
    node.width = 40, node.height = 60;
    return node;
  }

  /// A ground floor and an upper part, each with a grid of windows. The upper grid has the given
  /// type and, if it has cells, lacks the window in its lower right corner.
  void two_grids(const std::string& upper) {
    rewrite(0, {"FacadeRow", "PartFacade"}, {extent(160), Node()});
    rewrite(find("FacadeRow"), {"RegularIdenticalGrid"}, {lines(4, 1, 30, 120, 40, 0)});
    rewrite(find("RegularIdenticalGrid"), {"window"}, {window()});
    rewrite(find("PartFacade"), {upper}, {lines(4, 3, 30, 120, 40, 170)});
    const int grid = find(upper, find("PartFacade"));
    rewrite(grid, {"window"}, {window()});
    if (rules_.symbol(tree_[grid].symbol).identical) return;
    tree_[grid].cells = tree_[grid].full_cells();
    tree_[grid].set_kind(3, 2, 0);
  }

  /// Bits of the current tree, which must be valid; starts the next tree.
  double complexity() {
    TreeState state = model_.make_state(tree_);
    EXPECT_TRUE(model_.compute_areas(state));
    const double bits = model_.complexity(tree_);
    tree_ = model_.axiom_state().tree;
    return bits;
  }

  Rules rules_;
  Model model_;
  Tree tree_;
};

TEST_F(Figure5, ComplexitiesAreOrderedAsInThePaper) {
  std::vector<double> bits;
  bits.push_back(complexity());
  rewrite(0, {"SymmetricFacadeSide", "SymmetricFacadeMiddle"}, {Node(), extent(100)});
  bits.push_back(complexity());
  rewrite(0, {"FacadeRow", "PartFacade"}, {extent(160), Node()});
  bits.push_back(complexity());
  two_grids("RegularIdenticalGrid");
  bits.push_back(complexity());
  two_grids("RegularGrid");
  bits.push_back(complexity());
  rewrite(0, {"FacadeRow", "PartFacade"}, {extent(160), Node()});
  rewrite(find("FacadeRow"), {"RegularIdenticalGrid"}, {lines(4, 1, 30, 120, 40, 0)});
  rewrite(find("RegularIdenticalGrid"), {"window"}, {window()});
  rewrite(find("PartFacade"), {"SymmetricFacadeSide", "SymmetricFacadeMiddle"},
          {Node(), extent(140)});
  rewrite(find("SymmetricFacadeSide"), {"RegularGrid"}, {lines(2, 3, 20, 80, 40, 170)});
  rewrite(find("RegularGrid"), {"window"}, {window(), window()});
  tree_[find("RegularGrid")].cells = tree_[find("RegularGrid")].full_cells();
  tree_[find("RegularGrid")].set_kind(0, 0, 2);
  rewrite(find("SymmetricFacadeMiddle"), {"RegularIdenticalGrid"}, {lines(1, 3, 50, 1, 40, 170)});
  rewrite(find("RegularIdenticalGrid", find("SymmetricFacadeMiddle")), {"window"}, {window()});
  bits.push_back(complexity());

  const double symbol = std::log2(15);
  EXPECT_NEAR(bits[0], symbol, 1e-9);
  EXPECT_NEAR(bits[1], 3 * symbol + 9, 1e-9) << "the width of the middle";
  EXPECT_NEAR(bits[2], 3 * symbol + 10, 1e-9) << "the height of the ground floor";
  EXPECT_NEAR(bits[3], 7 * symbol + 10 + 2 * (8 + 2 * 9 + 2 * 10) + 2 * (9 + 10), 1e-9);
  // 12 nodes; a ground floor, its grid and window; a middle with the same; 2 x 3 cells of 2 kinds.
  EXPECT_NEAR(bits[5], 12 * symbol + 10 + 65 + 9 + 65 + (46 + 6 * 2 + 2 * 19), 1e-9);
  for (size_t i = 1; i < bits.size(); ++i) EXPECT_LT(bits[i - 1], bits[i]) << i;
}

TEST_F(Figure5, FourthAndFifthDifferOnlyInTheWindowMap) {
  two_grids("RegularIdenticalGrid");
  const double fourth = complexity();
  two_grids("RegularGrid");
  const double fifth = complexity();
  EXPECT_NEAR(fifth - fourth, 4 * 3 * 1, 1e-9) << "one bit per cell: a window or none";
}

}  // namespace
}  // namespace vug::fit
