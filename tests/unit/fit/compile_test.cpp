// SPDX-License-Identifier: Apache-2.0
// Compilation of the published grammar for the sampler.
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/model/model.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace vug::fit {
namespace {

Rules ripperda() { return compile(facade::load_rules(VUG_DATA "/facades/ripperda.vug")); }

TEST(Compile, ThePublishedGrammarHasItsSymbolsAndRules) {
  const Rules rules = ripperda();
  EXPECT_EQ(rules.symbols.size(), 15u);
  EXPECT_EQ(rules.productions.size(), 45u);
  std::map<Op, int> counts;
  for (const Production& production : rules.productions) ++counts[production.op];
  const std::map<Op, int> expected = {{Op::rows, 1},    {Op::repeat, 3},   {Op::mirror, 6},
                                      {Op::grid, 22},   {Op::elements, 1}, {Op::windows, 8},
                                      {Op::terminal, 4}};
  EXPECT_EQ(counts, expected);
  std::set<std::pair<bool, bool>> grids;
  for (const SymbolInfo& symbol : rules.symbols)
    if (symbol.grid) grids.emplace(symbol.regular, symbol.identical);
  EXPECT_EQ(grids.size(), 4u);
  EXPECT_EQ(rules.symbol(rules.axiom).name, "Facade");
}

TEST(Compile, TheWorkedExampleOfTheComplexity) {
  const Rules rules = ripperda();
  const Model model(rules, {}, 500, 700);
  TreeState state = model.axiom_state();
  const auto find_production = [&](const std::string& head, const std::string& part) {
    for (size_t i = 0; i < rules.productions.size(); ++i)
      if (rules.symbol(rules.productions[i].head).name == head &&
          rules.symbol(rules.productions[i].parts[0]).name == part)
        return static_cast<int>(i);
    return -1;
  };
  Node grid, window;
  grid.parent_op = static_cast<int8_t>(Op::grid), grid.columns = 4, grid.rows = 5;
  for (int i = 0; i < 5; ++i) {
    if (i < 4) grid.left[static_cast<size_t>(i)] = static_cast<int16_t>(20 + 110 * i);
    grid.top[static_cast<size_t>(i)] = static_cast<int16_t>(30 + 120 * i);
  }
  window.parent_op = static_cast<int8_t>(Op::windows), window.width = 50, window.height = 70;
  const int first = find_production("Facade", "RegularIdenticalGrid"),
            second = find_production("RegularIdenticalGrid", "window");
  grid.symbol = static_cast<int16_t>(rules.production(first).parts[0]);
  window.symbol = static_cast<int16_t>(rules.production(second).parts[0]);
  state.grow(0, first, {grid});
  state.grow(1, second, {window});
  EXPECT_NEAR(model.energy(state), 76.7207, 5e-5);
}

TEST(Compile, UnsupportedRulesAreRejectedWithTheirLocation) {
  const ScratchFolder scratch("vug_compile");
  const std::string file = scratch.file("rules.vug");
  const std::pair<std::string, std::string> cases[] = {
      {"Facade -> rows(3m, Low, 1, High)\n  Low -> window\n  High -> window", "sizes or counts"},
      {"Facade -> inset(Low)\n  Low -> window", "is not supported"},
      {"Facade -> Low\n  Low -> window", "is not a grid"},
      {"Facade @2 -> window", "a weight"},
  };
  for (const auto& [rule, said] : cases) {
    std::ofstream(file) << "grammar g: facade {\n  axiom Facade\n  " << rule << "\n}\n";
    try {
      compile(facade::load_rules(file));
      ADD_FAILURE() << rule;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << rule << "\n"
                                                                         << error.what();
      EXPECT_EQ(error.where().line, 3) << rule;
    }
  }
}

}  // namespace
}  // namespace vug::fit
