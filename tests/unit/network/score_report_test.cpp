// SPDX-License-Identifier: Apache-2.0
// Reports and drawings of scored networks.
#include "graphs.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/network/dat.h>
#include <vug/network/read_network.h>
#include <vug/network/score_plot.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace vug::network {
namespace {

/// A straight main passage with straight side passages, and cross-sections.
Network comb() {
  Network network;
  std::vector<Vec3d> line;
  for (int i = 0; i < 12; ++i) line.emplace_back(20.0 * i, 0, 0);
  add_chain(network, line);
  for (int i = 1; i < 11; i += 2) {
    const auto end = static_cast<int>(network.stations.size());
    network.stations.push_back({.position = {20.0 * i, 1, 15.0 + i}});
    add_leg(network, i, end);
  }
  return draw_sections(std::move(network), {}, 5);
}

size_t count(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(ScoreReport, TableHasALineForEachCriterionAndTheAdvice) {
  const ScoredNetwork cave = scored(comb(), "comb");
  const std::string table = score_table(cave);
  for (const Criterion& c : criteria())
    EXPECT_NE(table.find(std::string("\n") + c.name), std::string::npos) << c.name;
  for (const SectionCriterion& c : section_criteria())
    EXPECT_NE(table.find(std::string("\n") + c.name), std::string::npos) << c.name;
  EXPECT_NE(table.find("realism"), std::string::npos);
  EXPECT_NE(table.find("\nthe legs are too straight: tortuosity 1; real caves have 1.18 to 1.4"),
            std::string::npos)
      << table;
}

TEST(ScoreReport, JsonContainsTheNumbersOfTheScore) {
  const ScoredNetwork cave = scored(comb(), "comb");
  const nlohmann::ordered_json json = score_json(cave);
  EXPECT_EQ(json["legs"], 16);
  EXPECT_EQ(json["cross_sections"], 17);
  EXPECT_EQ(json["network"].size(), criteria().size());
  EXPECT_EQ(json["sections"].size(), section_criteria().size());
  EXPECT_DOUBLE_EQ(json["overall"].get<double>(), cave.realism.overall);
  EXPECT_EQ(json["network"][4]["name"], "tortuosity");
  EXPECT_NEAR(json["network"][4]["value"].get<double>(), 1, 1e-12);
  EXPECT_EQ(json["network"][4]["percentile"], 0);
  EXPECT_DOUBLE_EQ(json["network"][4]["real"]["p50"].get<double>(), 1.268);
  EXPECT_EQ(json["advice"].size(), cave.realism.advice().size());
}

TEST(ScoreReport, UndefinedValuesAreNullAndDashes) {
  Network network;
  add_chain(network, {{0, 0, 0}, {10, 0, 0}, {5, 8, 0}});
  add_leg(network, 2, 0);  // A ring has no branch with two ends.
  const ScoredNetwork cave = scored(network, "ring");
  EXPECT_NE(score_json(cave).dump().find("\"name\":\"tortuosity\",\"unit\":\"\",\"value\":null"),
            std::string::npos);
  EXPECT_NE(score_svg(cave).find("undefined"), std::string::npos);
}

TEST(ScoreReport, NetworksWithoutLegsAreErrors) {
  Network network;
  network.stations.push_back({.name = "alone"});
  EXPECT_THROW(scored(network, "alone"), Error);
  add_chain(network, {{0, 0, 0}, {10, 0, 0}});
  network.legs[0].surface = true;
  EXPECT_THROW(scored(network, "path"), Error);
}

TEST(ScorePlot, HasARowForEachCriterionInsideTheDrawing) {
  ScoredNetwork cave = scored(comb(), "comb <1>");
  const std::string svg = score_svg(cave);
  EXPECT_EQ(count(svg, "class=\"median\""), 1 + criteria().size() + section_criteria().size());
  EXPECT_EQ(count(svg, "comb &lt;1&gt;"), 2u);
  EXPECT_EQ(count(svg, "\"nan"), 0u);
  EXPECT_EQ(svg, score_svg(cave));
  cave.realism.network[1].value = 1e9;  // Beyond the axis: a triangle.
  EXPECT_EQ(count(score_svg(cave), "<path"), count(svg, "<path") + 1);
}

TEST(ReadNetwork, ReadsSurveysAndTextFiles) {
  const ScratchFolder scratch("vug_read_network");
  const std::filesystem::path& folder = scratch.path();
  Diagnostics warnings;
  write_dat(comb(), folder / "comb_nodes.dat");
  EXPECT_EQ(read_network(folder / "comb_links.dat", warnings).legs.size(), 16u);
  std::ofstream(folder / "CAVE.SVX") << "1 2 10 90 0\n2 3 5 80 0\n";
  EXPECT_TRUE(is_network_file("CAVE.SVX"));
  EXPECT_FALSE(is_network_file("rock.obj"));
  EXPECT_EQ(read_network(folder / "CAVE.SVX", warnings).legs.size(), 2u);
  EXPECT_THROW(read_network(folder / "rock.obj", warnings), Error);
}

}  // namespace
}  // namespace vug::network
