// SPDX-License-Identifier: Apache-2.0
// Chambers that grow: ids and places stay, sizes increase in small steps, and only breaks jump.
#include <vug/drips/growth.h>
#include <vug/drips/growth_report.h>
#include <vug/drips/inventory.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "rooms.h"

namespace vug::drips {
namespace {

constexpr double kVoxel = 0.03, kLastAge = 6000;

/// The chamber when its oldest drips have an age.
DripstoneOptions growing(double age) {
  DripstoneOptions o;
  o.graph = graph_options(3);
  o.graph.spacing = 0.3;
  o.graph.density = 0.8;
  o.graph.oldest = age;
  o.graph.final_age = kLastAge;
  o.forms.tip = 0.75 * kVoxel;
  o.forms.broken = 0.3;
  o.forms.age = age;
  o.forms.final_age = kLastAge;
  o.draperies = {.share = 1, .tip = o.forms.tip, .floor = -3};
  o.flowstone = {.share = 1};
  return o;
}

Dripstone chamber(double age, Graph* graph = nullptr) {
  const field::Field rock = cave(6, 0.5, 6);
  const DripstoneOptions o = growing(age);
  const Graph drips = build_graph(rock, o.graph);
  if (graph) *graph = drips;
  return grow_dripstone(rock, drips, o);
}

TEST(Growing, KeepsPlacesAndIdsOfTheGraph) {
  Graph young, old;
  chamber(40, &young);
  chamber(kLastAge, &old);
  ASSERT_EQ(young.nodes.size(), old.nodes.size());
  ASSERT_EQ(young.edges.size(), old.edges.size());
  for (size_t i = 0; i < young.nodes.size(); ++i) {
    const Node &a = young.nodes[i], &b = old.nodes[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.plane, b.plane);
    EXPECT_EQ(a.water.discharge, b.water.discharge);
    EXPECT_NEAR(a.water.age * kLastAge, b.water.age * 40, 1e-6 * kLastAge * b.water.age);
  }
}

TEST(Growing, NothingPopsOrDisappears) {
  GrowthCheck check;
  const int frames = 120;
  for (int frame = 1; frame <= frames; ++frame) {
    const double age = kLastAge * frame / frames;
    check.add(frame, chamber(age), growing(age).forms);
  }
  const GrowthReport& report = check.report();
  EXPECT_EQ(report.frames, 120u);
  EXPECT_GT(report.speleothems, 200u);
  EXPECT_TRUE(report.lost.empty())
      << report.lost.size() << " " << report.lost.front().kind << " " << report.lost.front().drip
      << " at " << report.lost.front().frame;
  EXPECT_LT(report.first.size, kVoxel)
      << report.first.kind << " " << report.first.drip << " at " << report.first.frame;
  EXPECT_LT(report.step.size, kVoxel)
      << report.step.kind << " " << report.step.drip << " at " << report.step.frame;
  EXPECT_GT(report.step.size, 0.001);
  // Breaks are events of their own, between half of the last age and its end.
  EXPECT_GT(report.broken.size(), 3u);
  std::set<int64_t> once;
  for (const GrowthEvent& event : report.broken) {
    EXPECT_TRUE(once.insert(event.drip).second) << "a stalactite breaks once";
    EXPECT_GE(event.frame, frames / 2);
    EXPECT_GT(event.size, kVoxel);
  }
}

TEST(Growing, SizesOnlyIncreaseUnlessAFormBreaks) {
  std::map<std::pair<std::string, int64_t>, Speleothem> before;
  int grown = 0, met = 0;
  for (double age = 100; age < 8 * kLastAge; age *= 1.3) {
    DripstoneOptions o = growing(age);
    o.graph.final_age = o.forms.final_age = 8 * kLastAge;
    o.forms.broken = 0;
    const field::Field rock = cave(6, 0.5, 6);
    const Graph graph = build_graph(rock, o.graph);
    std::map<std::pair<std::string, int64_t>, Speleothem> now;
    for (const Speleothem& s : inventory(grow_dripstone(rock, graph, o), graph)) {
      now[{s.kind, s.drip}] = s;
      met += s.kind == std::string("column");
    }
    for (const auto& [name, old] : before) {
      ASSERT_TRUE(now.contains(name)) << name.first << " " << name.second;
      const Speleothem& s = now[name];
      EXPECT_GE(s.size, old.size - 1e-9) << name.first << " " << name.second;
      EXPECT_GE(s.length, old.length - 0.002) << name.first << " " << name.second;
      grown += s.size > old.size;
    }
    before = std::move(now);
  }
  EXPECT_GT(grown, 500);
  EXPECT_GT(met, 5);
}

TEST(Growing, APartThatBrokeIsThatOfItsTime) {
  // Nothing grows on a stump whose drip has another way: it stays as it was when it broke.
  std::map<int64_t, Form> stumps, pieces;
  int compared = 0;
  for (const double age : {0.96 * kLastAge, 0.98 * kLastAge, kLastAge}) {
    for (const Form& form : chamber(age).forms) {
      if (form.kind == FormKind::piece) {
        const auto [place, added] = pieces.emplace(form.drip, form);
        EXPECT_NEAR(form.radius, place->second.radius, 1e-12);
        EXPECT_NEAR((form.top - place->second.top).length(), 0, 1e-9);
      }
      if (!(form.broken > 0)) continue;
      const auto [place, added] = stumps.emplace(form.drip, form);
      EXPECT_NEAR((form.top - form.bottom).length(),
                  (place->second.top - place->second.bottom).length(), 1e-9);
      EXPECT_GE(form.regrown, place->second.regrown - 1e-12);
      EXPECT_GE(form.since, place->second.since);
      compared += !added;
    }
  }
  EXPECT_GT(compared, 6);
  EXPECT_FALSE(pieces.empty());
}

TEST(StalactiteGrowth, IncreasesWithTheAgeAndLeavesMoreAndMoreCalcium) {
  const field::StalactiteCurve curve = common_curve(0.05);
  for (const double interval : {5.0, 60.0, 2000.0}) {
    Water water{1e-7 / interval, 2.25, 10, 0};
    double length = 0, passed = 0, rate = kInfinity;
    for (int i = 1; i <= 400; ++i) {
      water.age = 250.0 * i;
      const StalactiteGrowth growth = grow_stalactite(water, interval, curve);
      EXPECT_GT(growth.length, length);
      EXPECT_LT(growth.length - length, 0.08);
      const double calcium = growth.calcium * water.age;
      EXPECT_GT(calcium, passed) << "what has dripped off does not come back";
      EXPECT_LT((growth.length - length), 1.001 * rate) << "it grows ever more slowly";
      rate = growth.length - length;
      length = growth.length, passed = calcium;
    }
  }
}

}  // namespace
}  // namespace vug::drips
