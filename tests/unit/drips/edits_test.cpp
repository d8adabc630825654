// SPDX-License-Identifier: Apache-2.0
// Drips that users add, move and remove.
#include <vug/base/error.h>
#include <vug/drips/build_graph.h>
#include <vug/drips/inventory.h>

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
