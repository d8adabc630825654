// SPDX-License-Identifier: Apache-2.0
// Drips that users add, move and remove.
#include <vug/base/error.h>
#include <vug/drips/build_graph.h>
#include <vug/drips/inventory.h>
#include <vug/drips/lost_drips.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rooms.h"

namespace vug::drips {
namespace {

std::vector<Seep> seeps(const DripEdits& edits) {
  const field::Field rock = hall();
  const GraphOptions o = graph_options(3);
  return edited(find_seeps(rock, o), rock, o, edits);
}

const Seep* find(const std::vector<Seep>& seeps, int64_t id) {
  const auto found =
      std::find_if(seeps.begin(), seeps.end(), [&](const Seep& s) { return s.id == id; });
  return found == seeps.end() ? nullptr : &*found;
}

std::string message(const DripEdits& edits) {
  try {
    seeps(edits);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Edits, ChangeTheDripsThatTheyNameAndNoOthers) {
  const std::vector<Seep> before = seeps({});
  ASSERT_GT(before.size(), 10u);
  const int64_t moved = before[2].id, removed = before[5].id;
  const std::vector<Seep> after = seeps({.removed = {{removed}},
                                         .moved = {{moved, Vec3d(0.5, 0, 0.5)}},
                                         .added = {{Vec3d(-1, 0, 1), 20, 4000}}});
  EXPECT_EQ(after.size(), before.size());
  EXPECT_EQ(find(after, removed), nullptr);
  for (const Seep& seep : before) {
    const Seep* same = find(after, seep.id);
    if (seep.id == removed) continue;
    ASSERT_TRUE(same);
    if (seep.id == moved) {
      EXPECT_EQ(same->position.x, 0.5);
      EXPECT_EQ(same->position.z, 0.5);
      EXPECT_NEAR(hall().value(same->position), 0, 1e-5) << "it lies on the roof";
      EXPECT_LT(same->normal.y, 0);
    } else {
      EXPECT_EQ(same->position, seep.position);
    }
    EXPECT_EQ(same->interval, seep.interval);
    EXPECT_EQ(same->age, seep.age);
  }
  const Seep* added = find(after, -1);
  ASSERT_TRUE(added);
  EXPECT_EQ(added->interval, 20);
  EXPECT_EQ(added->age, 4000);
  EXPECT_TRUE(std::is_sorted(after.begin(), after.end(),
                             [](const Seep& a, const Seep& b) { return a.id < b.id; }));
}

TEST(Edits, KeepTheWettestDripsOfABudget) {
  const std::vector<Seep> all = seeps({});
  const std::vector<Seep> few = seeps({.budget = 7, .added = {{Vec3d(0, 0, 0)}}});
  ASSERT_EQ(few.size(), 8u) << "added drips do not count";
  double slowest = 0;
  for (const Seep& seep : few)
    if (seep.id >= 0) slowest = std::max(slowest, seep.interval);
  for (const Seep& seep : all) {
    if (!find(few, seep.id)) {
      EXPECT_GE(seep.interval, slowest);
    }
  }
}

TEST(Edits, GrowAStalagmiteBelowADripThatWasAdded) {
  GraphOptions o = graph_options(3);
  o.density = 0;
  o.edits.added = {{Vec3d(0.4, 0, -0.3), 40, 9000}};
  const Graph graph = build_graph(hall(), o);
  const std::vector<Form> forms = forms_of(graph, {.stalagmites = 1});
  const auto standing = std::find_if(forms.begin(), forms.end(), [](const Form& form) {
    return form.kind == FormKind::stalagmite || form.kind == FormKind::column;
  });
  ASSERT_NE(standing, forms.end());
  EXPECT_EQ(standing->drip, -1);
  EXPECT_NEAR(standing->interval, 40, 1e-9);
  EXPECT_EQ(explain(listed(*standing), 0, graph)
                .rfind("stalagmite 0: drip -1, 40 s a drop, 9,000 years", 0),
            0u);
}

/// Faults of drips that are added to a roof without others.
std::vector<LostDrip> lost(GraphOptions o, const std::vector<Vec3d>& points) {
  o.density = 0;
  for (size_t i = 0; i < points.size(); ++i)
    o.edits.added.push_back({points[i], 60, 1000, {"t.vug", static_cast<int>(i) + 1, 7}});
  std::vector<LostDrip> whole = lost_drips(build_graph(hall(), o), o);
  const std::vector<LostDrip> alone = lost_drips(ways_of_edits(hall(), o), o);
  EXPECT_EQ(whole.size(), alone.size());
  for (size_t i = 0; i < whole.size() && i < alone.size(); ++i)
    EXPECT_EQ(whole[i].message, alone[i].message);
  return whole;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Edits, ThatHaveNoEffectAreFoundWithTheirReason) {
  const Vec3d middle(0.4, 0, -0.3);
  EXPECT_TRUE(lost(graph_options(3), {middle, {-0.4, 0, 0.3}}).empty());
  const auto leaving = lost(graph_options(1.5), {middle, {1.499, 0, 0}});
  ASSERT_EQ(leaving.size(), 1u);
  EXPECT_EQ(leaving[0].where.line, 2);
  EXPECT_TRUE(contains(leaving[0].message, "the added drip -2 does not drip"))
      << leaving[0].message;
  EXPECT_TRUE(contains(leaving[0].message, "it leaves the box")) << leaving[0].message;
  GraphOptions high = graph_options(3);
  high.from.y = -1;
  const auto deep = lost(high, {middle});
  ASSERT_EQ(deep.size(), 1u);
  EXPECT_TRUE(contains(deep[0].message, "a floor below was found")) << deep[0].message;
  const auto twice = lost(graph_options(3), {middle, middle});
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_TRUE(contains(twice[0].message, "its water joins that of drip -")) << twice[0].message;
}

TEST(Edits, AMovedDripIsFollowedWithoutTheOthers) {
  GraphOptions o = graph_options(1.5);
  const std::vector<Seep> before = find_seeps(hall(), o);
  ASSERT_GT(before.size(), 3u);
  o.edits.moved = {{before[1].id, Vec3d(1.499, 0, 0), {"t.vug", 4, 2}},
                   {before[2].id, Vec3d(-0.5, 0, 0.1), {"t.vug", 5, 2}}};
  const Graph ways = ways_of_edits(hall(), o);
  for (const Node& node : ways.nodes)
    EXPECT_TRUE(node.id == before[1].id || node.id == before[2].id) << node.id;
  const std::vector<LostDrip> found = lost_drips(ways, o);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where.line, 4);
  EXPECT_TRUE(contains(found[0].message, "the moved drip")) << found[0].message;
}

TEST(Edits, TheirPlacesInATextAreNoPartOfDigests) {
  DripEdits a{.removed = {{3}}, .moved = {{4, Vec3d(1.0)}}, .added = {{Vec3d(2.0)}}}, b = a;
  b.removed[0].where = b.moved[0].where = b.added[0].where = {"t.vug", 4, 2};
  EXPECT_EQ(digest_of(a), digest_of(b));
  b.removed[0].drip = 5;
  EXPECT_NE(digest_of(a), digest_of(b));
}

TEST(Edits, ReportFaultsWithTheirRemedies) {
  const int64_t id = seeps({}).front().id;
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(message({.removed = {{7777777}}}), "drip 7777777 is removed, but the roof has no such drip");
  has(message({.moved = {{7777777, Vec3d(0.0)}}}), "drip 7777777 is moved");
  has(message({.removed = {{id}, {id}}}), "moved or removed twice");
  has(message({.added = {{Vec3d(0, 50, 0)}}}), "outside the box of the drips");
  has(message({.added = {{Vec3d(0, 2.95, 0)}}}), "in solid rock");
  has(message({.moved = {{id, Vec3d(0, 2.95, 0)}}}), "in solid rock");
  has(message({.added = {{Vec3d(0, 0, 0), 0.0}}}), "water must flow");
  has(message({.added = {{Vec3d(0, 0, 0), 60, -5}}}), "the age of a drip is -5 years");
  has(message({.added = {{Vec3d(0, 0, 0), 60, 1e6}}}), "the oldest ones are");
}

}  // namespace
}  // namespace vug::drips
