// SPDX-License-Identifier: Apache-2.0
// Speleothems stand where their water comes from, and their solids are sound.
#include <vug/drips/dripstone.h>
#include <vug/drips/growth.h>
#include <vug/drips/inventory.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "rooms.h"

namespace vug::drips {
namespace {

GraphOptions options(double half = 3) {
  GraphOptions o = graph_options(half);
  o.run_out = false;
  return o;
}

TEST(Forms, StandUnderTheirDrops) {
  const Graph graph = build_graph(cave(20, 0.05, 20), options(10));
  std::map<int64_t, Node> drops;
  for (const Node& node : graph.nodes)
    if (node.kind == NodeKind::drop) drops[node.id] = node;
  int standing = 0;
  for (const Form& form : forms_of(graph, {})) {
    ASSERT_TRUE(drops.contains(form.drip)) << "none is without a source";
    if (form.kind != FormKind::stalagmite) continue;
    ++standing;
    const Node& drop = drops[form.drip];
    const double height = drop.position.y - form.top.y;
    EXPECT_LT(std::hypot(form.top.x - drop.tip.x, form.top.z - drop.tip.z), 0.03 + 0.01 * height);
    const double lean = std::hypot(form.top.x - form.bottom.x, form.top.z - form.bottom.z);
    EXPECT_LE(lean, std::tan(5 * kPi / 180) * (form.top.y - form.bottom.y));
  }
  EXPECT_GT(standing, 200);
}

TEST(Forms, HaveHeavyTailedLengthsAndRadiiOfTheirDrips) {
  GraphOptions o = options(10);
  o.straws = 0;
  const Graph graph = build_graph(cave(20, 0.05, 20), o);
  double n = 0, sum = 0, squares = 0;
  for (const Form& form : forms_of(graph, {})) {
    const double length = (form.top - form.bottom).length();
    if (form.kind == FormKind::stalactite && form.sunk == 0) {
      n += 1, sum += std::log(length), squares += std::log(length) * std::log(length);
      // One common scale: nearly the power 3/4 of the length.
      EXPECT_NEAR(form.radius, 0.05 * std::pow(length, 0.75), 0.12 * form.radius + 0.002);
    }
    if (form.kind == FormKind::stalagmite) {
      EXPECT_GE(form.radius, 0.015);
      EXPECT_LE(form.radius, 0.17);
    }
  }
  ASSERT_GT(n, 300);
  EXPECT_GT(std::sqrt(squares / n - sum * sum / n / n), 0.7);
}

TEST(Forms, StrawsAreAsWideAsDrops) {
  GraphOptions o = options();
  o.straws = 1;
  int straws = 0;
  for (const Form& form : forms_of(build_graph(hall(), o), {})) {
    if (form.kind != FormKind::straw) continue;
    ++straws;
    EXPECT_NEAR(2 * form.radius, 0.0051, 1e-4);
  }
  EXPECT_GT(straws, 20);
}

TEST(Forms, HangFromTheRoofAndReachTheirEnds) {
  const field::Field rock = hall();
  GraphOptions graph_options = options();
  graph_options.oldest = 1e5;
  const Graph graph = build_graph(rock, graph_options);
  FormOptions o;
  o.tip = 0.01;
  std::map<FormKind, int> counts;
  for (const Form& form : forms_of(graph, o)) {
    ++counts[form.kind];
    const field::Field alone = form_field(form, o, common_curve(o.girth));
    const Vec3d axis = (form.bottom - form.top).normalized();
    const double length = (form.bottom - form.top).length();
    const bool hangs = form.kind != FormKind::stalagmite;
    if (hangs) {
      EXPECT_LT(rock.value(form.top - Vec3d(0, 0.002, 0)), 0.01) << "it hangs from the roof";
      EXPECT_LT(alone.value(form.top + Vec3d(0, 0.5 * form.root, 0)), 0) << "it enters the rock";
    }
    for (double t = 0.02; t < 0.98 - form.broken; t += 0.05) {
      const Vec3d p = form.top + axis * (length * t);
      EXPECT_LT(alone.value(p), 0) << static_cast<int>(form.kind) << " is whole at " << t;
    }
    if (hangs && form.kind != FormKind::column) {
      EXPECT_GT(alone.value(form.bottom + axis * (2 * o.tip)), 0) << "it ends";
    }
    if (form.broken > 0) {
      EXPECT_GT(alone.value(form.bottom - axis * (0.5 * form.broken * length)), 0) << "it broke";
    }
    const Vec3d beside =
        form.top + axis * (0.5 * length) + Vec3d(1.7 * form.radius + 2 * form.coat + o.tip, 0, 0);
    EXPECT_GT(alone.value(beside), 0) << "it is not thicker than its root";
    const Box3d bounds = dripstone_bounds(rock.bounds(), graph_options, o);
    EXPECT_TRUE(bounds.intersects(alone.bounds().min) && bounds.intersects(alone.bounds().max));
  }
  for (const FormKind kind : {FormKind::stalactite, FormKind::stalagmite, FormKind::column})
    EXPECT_GT(counts[kind], 5) << static_cast<int>(kind);
}

TEST(Forms, AreNotThumbsButComeOutOfTheRoof) {
  const Graph graph = build_graph(hall(), options());
  FormOptions o;
  o.tip = 0.03;
  for (const Form& form : forms_of(graph, o))
    if (form.kind == FormKind::stalactite) {
      EXPECT_GE((form.top - form.bottom).length() + form.sunk, 6 * o.tip - 1e-12);
      EXPECT_LT(form.sunk, 6 * o.tip);
    }
}

TEST(Forms, AnyGirthTipAndAgeGiveSolids) {
  for (const double girth : {0.005, 0.05, 0.5})
    for (const double tip : {0.001, 0.02, 0.3})
      for (const double oldest : {100.0, 1e5}) {
        GraphOptions o = options();
        o.girth = girth, o.oldest = oldest, o.density = 0.2;
        FormOptions forms;
        forms.girth = girth, forms.tip = tip, forms.stalagmites = 1;
        const std::vector<Form> all = forms_of(build_graph(hall(), o), forms);
        const field::Field grown = field::unite(form_fields(all, forms));
        if (all.empty()) continue;
        const Box3d bounds = dripstone_bounds(hall().bounds(), o, forms);
        EXPECT_TRUE(bounds.intersects(grown.bounds().min) && bounds.intersects(grown.bounds().max))
            << girth << " " << tip << " " << oldest;
      }
}

TEST(Explain, NamesSourceRateAndAge) {
  Graph graph;
  graph.planes = {"joint 3"};
  Speleothem form;
  form.kind = "stalagmite";
  form.drip = 96, form.interval = 55.3, form.age = 41234, form.plane = 0;
  EXPECT_EQ(explain(form, 214, graph),
            "stalagmite 214: drip 96 on joint 3, 55 s a drop, 41,000 years");
  form.interval = 134;
  EXPECT_NE(explain(form, 2, graph).find("130 s a drop"), std::string::npos);
  form.plane = -1, form.interval = 7200, form.age = 900, form.kind = "straw";
  EXPECT_EQ(explain(form, 1, graph), "straw 1: drip 96, 120 min a drop, 900 years");
  form.kind = "column", form.since = 314;
  EXPECT_EQ(explain(form, 1, graph),
            "column 1: drip 96, 120 min a drop, 900 years, met 310 years ago");
}

}  // namespace
}  // namespace vug::drips
