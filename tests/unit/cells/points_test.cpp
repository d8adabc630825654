// SPDX-License-Identifier: Apache-2.0
// Conversion of cells to points of a file and back.
#include "run.h"

#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/cells/to_points.h>
#include <vug/volume/io.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vug::cells {
namespace {

namespace fs = std::filesystem;

/// Digests of all cell data, independent of order.
std::map<std::string, Digest> carried(const Simulation& s) {
  std::map<std::string, Digest> out;
  for (const Attribute& a : s.attributes().all())
    std::visit(
        [&](const auto& c) {
          out[a.name] = vug::digest(c.now.data(), c.now.size() * sizeof c.now[0]);
        },
        a.column);
  out["the state"] = vug::digest(s.states().data(), s.states().size());
  return out;
}

std::vector<Stage> some_of_all(const std::string& last) {
  NamedValues parameters;
  for (const ParamInfo& param : find_kind(rules(), last)->info.params)
    if (param.required)
      parameters.emplace_back(param.name, param.type == "text" ? Value("v") : Value(0.5));
  return {stage("random_color", {{"share", 0.1}}, 1),
          stage("sprinkle", {{"attribute", "v"}, {"share", 0.01}, {"radius", 0.1}}, 1),
          stage("sprinkle", {{"attribute", "alive"}, {"whole", true}}, 1),
          stage("corrosion", {{"share", 0.2}, {"loss", 0.3}}, -1,
                8),  // So that some cells are removed.
          stage(last, parameters)};
}

/// Through a grid, which changes their order.
volume::Points through_grid(const Simulation& s, PointFormat keep) {
  return volume::points(volume::point_grid(to_points(s, keep), voxel_of_points(s.network())));
}

TEST(CellPoints, ContinueToTheSameBytesWithEveryRule) {
  const NetworkPtr n = uneven(0.05);
  for (const RuleKind* kind : rules()) {
    const std::vector<Stage> stages = some_of_all(kind->info.name);
    const Simulation whole = ran(n, stages, 25);
    for (const int stop : {0, 5, 13}) {
      const volume::Points kept = through_grid(ran(n, stages, stop), PointFormat::exact);
      Simulation again(n, RandomKey(1));
      restore(again, kept, stop, PointFormat::exact);
      again.run(stages, 25 - stop);
      EXPECT_EQ(carried(again), carried(whole)) << kind->info.name << " from " << stop;
      EXPECT_EQ(again.step(), whole.step());
    }
  }
}

TEST(CellPoints, HaveTheAttributesThatOtherProgramsExpect) {
  const NetworkPtr n = uneven();
  Simulation s = ran(n, some_of_all("melting"), 20);
  const ScratchFolder scratch("vug_cells");
  const fs::path file = scratch.file("points.vdb");
  volume::write(file, {volume::point_grid(to_points(s), voxel_of_points(*n)).named("crust")});
  const volume::FileInfo info = volume::info(file);
  std::string lines;
  for (const auto& each : info.grids[0].points->attributes)
    lines += each.name + ' ' + each.type + ' ' + each.codec + '\n';
  EXPECT_EQ(lines.substr(0, lines.find("Cd")),
            "P vec3s fxpt16\nid int32 null\nN vec3s trnc\npscale float trnc\n");
  EXPECT_NE(lines.find("Cd vec3s trnc\n"), std::string::npos);
  EXPECT_NE(lines.find("v float null\n"), std::string::npos);
  EXPECT_NE(lines.find("seed int32 null\n"), std::string::npos);
  std::map<std::string, uint64_t> states;
  for (const CellState state : s.states()) ++states[std::string(name_of(state))];
  for (const auto& group : info.grids[0].points->groups)
    EXPECT_EQ(group.points, states[group.name]) << group.name;
  EXPECT_GT(states["transparent"], 0u);
  double area = 0, discs = 0;
  const volume::Points points = volume::read_points(file, "crust");
  for (const float r : points.values<float>("pscale")) discs += kPi * static_cast<double>(r * r);
  for (const float a : n->area) area += static_cast<double>(a);
  EXPECT_NEAR(discs, area, 1e-3 * area);
}

TEST(CellPoints, InterchangePointsAreRestoredApproximately) {
  const NetworkPtr n = uneven();
  const Simulation s = ran(n, some_of_all("melting"), 20);
  const double off = voxel_of_points(*n) / 65535 + 1e-6;
  Simulation again(n, RandomKey(1));
  restore(again, through_grid(s, PointFormat::interchange), 20, PointFormat::interchange, off);
  const auto &was = s.attributes().values<Vec3f>("P"), &is = again.attributes().values<Vec3f>("P");
  for (size_t i = 0; i < n->size(); ++i) EXPECT_LT((was[i] - is[i]).length(), off);
  EXPECT_EQ(again.states(), s.states());
  EXPECT_EQ(again.attributes().values<float>("v"), s.attributes().values<float>("v"));
  EXPECT_EQ(again.attributes().find("pscale"), nullptr);
  // Cells that have not moved are not marked as moved.
  Simulation still(n, RandomKey(1));
  restore(still, through_grid(ran(n, some_of_all("voronoi"), 20), PointFormat::interchange), 20,
          PointFormat::interchange, off);
  EXPECT_EQ(still.attributes().find("P"), nullptr);
  EXPECT_EQ(still.attributes().find("N"), nullptr);
}

template <class Work>
std::string fault(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(CellPoints, OfOtherCellsAreRefused) {
  const NetworkPtr n = uneven();
  Simulation s(n, RandomKey(1));
  volume::Points points = to_points(s, PointFormat::exact);
  std::get<std::vector<int32_t>>(points.attributes[0].values)[7] = 6;
  EXPECT_EQ(fault([&] { restore(s, points, 0, PointFormat::exact); }),
            "the ids of the points are not consecutive from 0");
  Simulation other(uneven(0.07), RandomKey(1));
  EXPECT_NE(fault([&] { restore(other, points, 0, PointFormat::exact); }).find(" points, but "),
            std::string::npos);
  points = to_points(s, PointFormat::exact);
  points.groups.clear();
  EXPECT_EQ(fault([&] { restore(s, points, 0, PointFormat::exact); }),
            "the points have no group 'sleeping'");
  s.attributes().column<float>("id");
  EXPECT_EQ(fault([&] { to_points(s); }),
            "cells have an attribute 'id', which is reserved for the numbers of points");
}

}  // namespace
}  // namespace vug::cells
