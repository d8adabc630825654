// SPDX-License-Identifier: Apache-2.0
// Code lengths compared with closed forms.
#include "enumeration.h"

#include <vug/fit/move.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

/// Rules with the number of symbols of the published grammar.
Rules fifteen_symbols() {
  Rules rules =
      rules_of({"Facade grid RegularIdenticalGrid", "RegularIdenticalGrid windows Window"});
  while (rules.symbols.size() < 15) find_or_add(rules, std::to_string(rules.symbols.size()));
  return with_index(rules);
}

TEST(Model, ComplexityOfTheWorkedExample) {
  const Rules rules = fifteen_symbols();
  const Model model(rules, {}, 500, 700);
  TreeState state = model.axiom_state();
  Node grid, window;
  grid.symbol = 1, grid.parent_op = static_cast<int8_t>(Op::grid);
  grid.columns = 3, grid.rows = 2;
  grid.left = {10, 110, 210}, grid.top = {20, 200};
  window.symbol = 2, window.parent_op = static_cast<int8_t>(Op::windows);
  window.width = 40, window.height = 60;
  state.grow(0, 0, {grid});
  state.grow(1, 1, {window});
  EXPECT_NEAR(model.energy(state), 3 * std::log2(15) + 46 + 19, 1e-12);
  EXPECT_NEAR(model.energy(state), 76.7207, 5e-5);
}

/// Bricks with windows in two columns and two rows, and noise.
std::vector<uint8_t> wall(int width, int height, bool mirrored) {
  RandomStream stream{RandomKey(4)};
  std::vector<uint8_t> out(static_cast<size_t>(width * height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool window = x % 20 > 6 && x % 20 < 13 && y % 15 > 3 && y % 15 < 10;
      const bool speck = stream.below(10) == 0;
      out[static_cast<size_t>(y * width + (mirrored ? width - 1 - x : x))] =
          static_cast<uint8_t>((window ? 1 : 0) ^ (speck ? 1 : 0));
    }
  return out;
}

TEST(Model, AMirrorImageHasTheSameScore) {
  constexpr int kWidth = 41, kHeight = 30;
  const Rules rules = rules_of({"Facade grid IdenticalGrid", "IdenticalGrid windows Window Door"});
  Node grid, window, door;
  grid.symbol = 1, grid.parent_op = static_cast<int8_t>(Op::grid), grid.columns = 2, grid.rows = 2;
  grid.left = {6, 28}, grid.top = {4, 18};
  window.symbol = 2, window.parent_op = static_cast<int8_t>(Op::windows);
  window.width = 7, window.height = 6;
  door = window;
  door.symbol = 3, door.x = 26, door.y = 20, door.width = 8, door.height = 10;
  double energies[2];
  for (const bool mirrored : {false, true}) {
    const Evidence pixels =
        Evidence::from_clusters(kWidth, kHeight, 2, wall(kWidth, kHeight, mirrored));
    const Model model(rules, {}, kWidth, kHeight, {&pixels, make_likelihood("kt", pixels)});
    TreeState state = model.axiom_state();
    Node g = grid, d = door;
    if (mirrored) g.left = {kWidth - 28 - 7, kWidth - 6 - 7}, d.x = kWidth - 26 - 8;
    state.grow(0, 0, {g});
    state.grow(1, 1, {window, d});
    energies[mirrored] = model.energy(state);
    int windows = 0;
    model.each_terminal(state, [&](RegionType type, int, const Rect& rect) {
      windows += type == RegionType::window ? 1 : 0;
      if (type == RegionType::door) {
        EXPECT_EQ(rect, (mirrored ? Rect{7, 20, 15, 30} : Rect{26, 20, 34, 30}));
      }
    });
    EXPECT_EQ(windows, 3) << "the door replaces the fourth";
  }
  EXPECT_NEAR(energies[0], energies[1], 1e-9);
}

TEST(Model, RepetitionsCostParametersOnceAndPixelsEachTime) {
  constexpr int kTimes = 4, kWidth = 20 * kTimes, kHeight = 30;
  const Rules rules =
      rules_of({"Facade repeat Part", "Facade mirror Side", "Part grid RegularIdenticalGrid",
                "RegularIdenticalGrid windows Window"});
  const Evidence pixels = Evidence::from_clusters(kWidth, kHeight, 2, wall(kWidth, kHeight, false));
  const Model model(rules, {}, kWidth, kHeight, {&pixels, make_likelihood("paper", pixels)});
  Node part, grid, window;
  part.symbol = 1, part.parent_op = static_cast<int8_t>(Op::repeat), part.extent = kTimes;
  grid.symbol = 3, grid.parent_op = static_cast<int8_t>(Op::grid), grid.columns = 1, grid.rows = 2;
  grid.left = {7}, grid.top = {4, 19};
  window.symbol = 4, window.parent_op = static_cast<int8_t>(Op::windows);
  window.width = 6, window.height = 6;
  TreeState state = model.axiom_state();
  state.grow(0, 0, {part});
  state.grow(1, 2, {grid});
  state.grow(2, 3, {window});
  model.energy(state);
  const double complexity = model.complexity(state.tree);
  EXPECT_NEAR(complexity, 4 * std::log2(5) + 4 + (8 + 2 * 7 + 2 * 5) + (7 + 5), 1e-9);
  Sums windows, walls;
  for (int i = 0; i < kTimes; ++i)
    for (const int y : {4, 19}) windows += pixels.sums(20 * i + 7, y, 20 * i + 13, y + 6);
  walls = pixels.sums(0, 0, kWidth, kHeight);
  walls -= windows;
  const double bits =
      std::min(windows.lane[0], windows.lane[1]) + std::min(walls.lane[0], walls.lane[1]);
  EXPECT_NEAR(model.energy(state), complexity + bits, 1e-9);
}

TEST(Model, EmptyElementsCostAsMuchAsFilledOnes) {
  const Rules rules =
      rules_of({"Row elements Element", "Element terminal Window", "Element terminal Door"});
  const Model model(rules, {}, 40, 20);
  Node element, window;
  element.symbol = 1, element.parent_op = static_cast<int8_t>(Op::elements), element.extent = 25;
  Node last = element;
  last.extent = 0;
  window.symbol = 2, window.parent_op = static_cast<int8_t>(Op::terminal);
  window.width = 15, window.height = 20;
  TreeState empty = model.axiom_state();
  empty.grow(0, 0, {element, last});
  TreeState full = empty;
  full.grow(2, 1, {window});
  EXPECT_NEAR(model.energy(empty), model.energy(full), 1e-12);
  EXPECT_NEAR(model.energy(full), 3 * std::log2(4) + 6 + 2 * (std::log2(4) + 2 * (6 + 5)), 1e-12);
}

TEST(Model, WindowsOfRepeatedPartsDoNotTouchTheirCopies) {
  const Rules rules = rules_of({"Facade mirror Side", "Facade grid IdenticalGrid",
                                "Side grid IdenticalGrid", "IdenticalGrid windows Window"});
  const Model model(rules, {}, 40, 20);
  const auto energy = [&](bool mirrored, int left) {
    Node side, grid, window;
    side.symbol = 1, side.parent_op = static_cast<int8_t>(Op::mirror);
    grid.symbol = 2, grid.parent_op = static_cast<int8_t>(Op::grid);
    grid.columns = 1, grid.rows = 1;
    grid.left = {static_cast<int16_t>(left)}, grid.top = {3};
    window.symbol = 3, window.parent_op = static_cast<int8_t>(Op::windows);
    window.width = 6, window.height = 6;
    TreeState state = model.axiom_state();
    if (mirrored) state.grow(0, 0, {side});
    state.grow(mirrored ? 1 : 0, mirrored ? 2 : 1, {grid});
    state.grow(mirrored ? 2 : 1, 3, {window});
    return model.energy(state);
  };
  EXPECT_TRUE(std::isfinite(energy(true, 13))) << "two pixels apart";
  EXPECT_FALSE(std::isfinite(energy(true, 14))) << "one window of twice the width";
  EXPECT_TRUE(std::isfinite(energy(false, 34))) << "at the picture's border";
}

TEST(Likelihoods, KtMatchesTheClosedForm) {
  const Evidence pixels = Evidence::from_clusters(2, 2, 2, {0, 0, 1, 0});
  EXPECT_NEAR(make_likelihood("kt", pixels)->bits(RegionType::wall, pixels.sums(0, 0, 2, 2)),
              std::log2(128.0 / 5), 1e-12);
  const Evidence many = Evidence::from_clusters(100, 30, 5, [] {
    std::vector<uint8_t> out;
    for (int i = 0; i < 3000; ++i) out.push_back(static_cast<uint8_t>(i * i % 5));
    return out;
  }());
  const Sums sums = many.sums(3, 2, 90, 27);
  double ln = std::lgamma(2.5) - std::lgamma(87 * 25 + 2.5);
  for (const uint32_t n : sums.lane)
    if (n > 0) ln += std::lgamma(n + 0.5) - std::lgamma(0.5);
  EXPECT_NEAR(make_likelihood("kt", many)->bits(RegionType::wall, sums), -ln / std::log(2), 1e-7);
}

TEST(Likelihoods, PaperCountsPixelsOutsideTheMainCluster) {
  const Evidence pixels = Evidence::from_clusters(3, 2, 4, {0, 1, 0, 3, 0, 2});
  EXPECT_DOUBLE_EQ(
      make_likelihood("paper", pixels)->bits(RegionType::wall, pixels.sums(0, 0, 3, 2)), 3 * 2);
}

TEST(Likelihoods, SupervisedSumsTheLaneOfTheRegionType) {
  std::vector<uint32_t> bits;
  for (uint32_t i = 0; i < 6; ++i)
    for (uint32_t type = 0; type < 4; ++type) bits.push_back(64 * (type + i));
  const Evidence maps(3, 2, 4, bits);
  const LikelihoodPtr likelihood = make_likelihood("supervised", maps);
  EXPECT_DOUBLE_EQ(likelihood->bits(RegionType::door, maps.sums(0, 0, 3, 1)), 2 * 3 + 0 + 1 + 2);
  EXPECT_THROW(make_likelihood("supervised", Evidence::from_clusters(1, 1, 2, {0})), Error);
  EXPECT_THROW(make_likelihood("kl", maps), Error);
}

TEST(Evidence, SumsMatchPixelByPixelSums) {
  constexpr int kWidth = 23, kHeight = 17;
  std::vector<uint32_t> values;
  RandomStream stream{RandomKey(6)};
  for (int i = 0; i < kWidth * kHeight * 3; ++i) values.push_back(stream.below(1000));
  const Evidence evidence(kWidth, kHeight, 3, values);
  for (int i = 0; i < 1000; ++i) {
    const auto draw = [&](int size) {
      return static_cast<int>(stream.below(static_cast<uint32_t>(size)));
    };
    const int x0 = draw(kWidth), y0 = draw(kHeight);
    const int x1 = x0 + draw(kWidth - x0 + 1), y1 = y0 + draw(kHeight - y0 + 1);
    Sums sums;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        for (int lane = 0; lane < 3; ++lane)
          sums.lane[static_cast<size_t>(lane)] +=
              values[static_cast<size_t>((y * kWidth + x) * 3 + lane)];
    ASSERT_TRUE(evidence.sums(x0, y0, x1, y1) == sums);
  }
  EXPECT_THROW(Evidence(0, 1, 1, {}), Error);
  EXPECT_THROW(Evidence(2, 1, 1, {1}), Error);
  EXPECT_THROW(Evidence(2, 1, 1, {4294967295u, 1}), Error);
  EXPECT_THROW(Evidence::from_clusters(1, 1, 2, {2}), Error);
}

}  // namespace
}  // namespace vug::fit
