// SPDX-License-Identifier: Apache-2.0
// Standing forms, their feet, and the pieces that lie between them.
#include <vug/base/parallel.h>
#include <vug/drips/chemistry.h>
#include <vug/drips/dripstone.h>
#include <vug/drips/form_fields.h>
#include <vug/drips/growth.h>
#include <vug/drips/trunk.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "rooms.h"

namespace vug::drips {
namespace {

GraphOptions dripping(double half = 3) {
  GraphOptions o = graph_options(half);
  o.run_out = false;
  o.oldest = 40000;
  return o;
}

Form candle(double height, double radius) {
  Form form;
  form.kind = FormKind::stalagmite;
  form.top = Vec3d(0, height, 0);
  form.radius = radius;
  return form;
}

TEST(Trunk, StaysAsItIsWhileTheApexGrows) {
  // No girdle moves: below the reach of the film, the outline does not depend on the height.
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const DripHistory history(RandomKey(seed), 0.05, 0.0);
    const std::vector<Vec2d> young = grown_trunk(candle(0.8, 0.05), 0.8, history),
                             old = grown_trunk(candle(1.6, 0.05), 1.6, history);
    for (double y = 0.02; y < 0.8 - 4 * 0.05; y += 0.05)
      EXPECT_NEAR(radius_at(young, y), radius_at(old, y), 0.12 * radius_at(old, y)) << seed;
  }
}

TEST(Trunk, HasGirdlesAndAFootButTheRadiusOfItsDripAtTheApex) {
  int waists = 0, feet = 0;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const DripHistory history(RandomKey(seed), 0.05, 0.0);
    const std::vector<Vec2d> outline = grown_trunk(candle(1.5, 0.05), 1.5, history);
    EXPECT_NEAR(outline.front().y, 1.5, 1e-9);
    EXPECT_NEAR(outline.back().y, 0, 1e-9);
    for (size_t i = 1; i < outline.size(); ++i) {
      EXPECT_LT(outline[i].y, outline[i - 1].y);
      EXPECT_GT(outline[i].x, 0.008);
      EXPECT_LT(outline[i].x, 0.3);
    }
    bool waist = false;
    for (double y = 0.2; y < 1.2; y += 0.02)
      waist |= radius_at(outline, y) < 0.98 * radius_at(outline, y + 0.06) &&
               radius_at(outline, y) < 0.98 * radius_at(outline, y - 0.06);
    waists += waist;
    feet += radius_at(outline, 0) > 1.15 * radius_at(outline, 0.4);
  }
  EXPECT_GT(waists, 25) << "no candles";
  EXPECT_GT(feet, 35);
}

/// The distance of the surface from the axis at the height `y`, in the direction `angle`.
double radius_of(const field::Field& form, double y, double angle) {
  double inside = 0, outside = 0.5;
  for (int i = 0; i < 40; ++i) {
    const double r = 0.5 * (inside + outside);
    (form.value(Vec3d(r * std::cos(angle), y, r * std::sin(angle))) < 0 ? inside : outside) = r;
  }
  return inside;
}

/// The standard deviation of the radius around the axis over its mean, at that height.
double unevenness(const field::Field& form, double y) {
  constexpr int kDirections = 24;
  double sum = 0, squares = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double r = radius_of(form, y, 2 * kPi * i / kDirections);
    sum += r;
    squares += r * r;
  }
  const double mean = sum / kDirections;
  return std::sqrt(std::max(0.0, squares / kDirections - mean * mean)) / mean;
}

TEST(Lumps, MakeTrunksUnevenWhereVoxelsCanShowThem) {
  const field::StalactiteCurve curve = common_curve(0.05);
  double fine = 0;
  for (int64_t drip = 0; drip < 10; ++drip) {
    Form form = candle(1.2, 0.06);
    form.drip = drip;
    fine += unevenness(form_field(form, {.tip = 0.005}, curve), 0.6) / 10;
    EXPECT_LT(unevenness(form_field(form, {.tip = 0.06}, curve), 0.6), 1e-5);
  }
  EXPECT_GT(fine, 0.04);
  EXPECT_LT(fine, 0.2);
}

TEST(Lumps, StayInPlaceWhileTheApexGrows) {
  const field::StalactiteCurve curve = common_curve(0.05);
  const Form low = candle(0.8, 0.05), high = candle(1.6, 0.05);
  const field::Field young = form_field(low, {.tip = 0.005}, curve),
                     old = form_field(high, {.tip = 0.005}, curve);
  for (double y = 0.05; y < 0.55; y += 0.05)
    for (double angle = 0; angle < 6; angle += 0.7) {
      const double now = radius_of(old, y, angle);
      EXPECT_NEAR(radius_of(young, y, angle), now, 0.12 * now);
    }
}

TEST(Skirts, HoldTheCalciteThatTheirWaterLost) {
  const Graph graph = build_graph(hall(), dripping());
  const std::vector<Form> forms = forms_of(graph, {});
  std::map<int64_t, const Node*> landings;
  for (const Node& node : graph.nodes)
    if (node.kind == NodeKind::landing) landings[node.id] = &node;
  int free = 0;
  for (const field::Deposit& skirt : skirts_of(graph, forms)) {
    ASSERT_TRUE(landings.contains(skirt.drip));
    const Node& at = *landings[skirt.drip];
    EXPECT_EQ(skirt.from, at.position);
    const double volume =
        field::kRoundShare * skirt.half_width_from * skirt.half_width_from * skirt.thickness_from;
    const Water& w = at.water;
    const double left = 0.5 * (w.calcium + equilibrium_calcium(w.temperature));
    const double lost = deposited_volume(w, w.calcium, left);
    EXPECT_LE(volume, lost * (1 + 1e-9));
    if (skirt.half_width_from > 0.05 && skirt.half_width_from < 0.68) {
      EXPECT_NEAR(volume, lost, 1e-3 * lost);
      ++free;
    }
  }
  EXPECT_GT(free, 10);
}

TEST(Pieces, LieOnTheRockBelowTheirStumps) {
  const field::Field rock = cave(8, 0.1, 8);
  GraphOptions o = dripping(4);
  o.straws = 0;
  const Graph graph = build_graph(rock, o);
  FormOptions forms;
  forms.broken = 1;
  const std::vector<Form> all = forms_of(graph, forms);
  std::map<int64_t, const Form*> stumps;
  int regrown = 0;
  for (const Form& form : all)
    if (form.broken > 0) {
      stumps[form.drip] = &form;
      regrown += form.regrown > 0;
    }
  EXPECT_GT(regrown, 20);
  const std::vector<Form> pieces = fallen_pieces(rock, all, graph, forms);
  EXPECT_GT(pieces.size(), 20u);
  for (const Form& piece : pieces) {
    ASSERT_TRUE(stumps.contains(piece.drip));
    const Form& stump = *stumps[piece.drip];
    const double length = (piece.top - piece.bottom).length();
    EXPECT_LE(length, stump.broken * (stump.top - stump.bottom).length() + 1e-9);
    EXPECT_LT(std::hypot(piece.top.x - stump.bottom.x, piece.top.z - stump.bottom.z),
              0.36 + length);
    // It touches the rock somewhere along its lower side and does not sink in.
    double gap = 1;
    for (double t = 0; t <= 1; t += 0.05) {
      const double radius = forms.tip + t * (piece.radius - forms.tip);
      const field::Gradient g = rock.gradient(piece.bottom + (piece.top - piece.bottom) * t);
      gap = std::min(gap, g.value / g.gradient.length() - radius);
    }
    EXPECT_LT(gap, 0.001);
    EXPECT_GT(gap, -0.5 * piece.radius - 0.01);
  }
}

TEST(Dripstone, KeepsItsPromises) {
  const field::Field rock = cave(8, 0.2, 8);
  GraphOptions o = dripping(4);
  o.run_out = true;
  const FormOptions forms{.tip = 0.01};
  const Dripstone grown = grow_dripstone(rock, build_graph(rock, o), {o, forms, {}, {}});
  EXPECT_LE(grown.solids.lipschitz(), kDripstoneSlope);
  EXPECT_GE(grown.solids.node()->traits().growth_rate(), kDripstoneGrowth);
  EXPECT_LE(grown.thickness.lipschitz(), field::kSteepestDeposit);
  const Box3d bounds = dripstone_bounds(rock.bounds(), o, forms);
  EXPECT_TRUE(bounds.intersects(grown.solids.bounds().min));
  EXPECT_TRUE(bounds.intersects(grown.solids.bounds().max));
  RandomStream random(RandomKey(7));
  for (int i = 0; i < 3000; ++i) {
    const Vec3d p(random.uniform(-4, 4), random.uniform(-2.2, 2.2), random.uniform(-4, 4));
    const Vec3d q = p + Vec3d(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02),
                              random.uniform(-0.02, 0.02));
    const double way = (q - p).length() + 1e-9;
    EXPECT_LE(std::fabs(grown.solids.value(p) - grown.solids.value(q)), kDripstoneSlope * way);
    const double thickness = grown.thickness.value(p);
    EXPECT_GE(thickness, 0);
    EXPECT_LE(thickness, field::kThickestDeposit);
    EXPECT_LE(std::fabs(thickness - grown.thickness.value(q)), field::kSteepestDeposit * way);
    // A restriction has the same values.
    const field::Ball ball{p, 0.1};
    const auto local = grown.thickness.restricted(ball);
    EXPECT_NEAR(local.field.value(q), grown.thickness.value(q), 1e-9);
    EXPECT_LE(local.range.lo - 1e-9, thickness);
    EXPECT_GE(local.range.hi + 1e-9, thickness);
  }
}

// Draperies with folds, pieces, trunks with feet, wide tips and thick stalactites.
TEST(Dripstone, StaysWithinBoundsThatAreNearTheRoom) {
  struct Case {
    double tip, girth, oldest;
    bool jointed;
    uint64_t seed;
  };
  const field::Field rock = cave();
  for (const Case& c : {Case{0.002, 0.05, 8000, false, 1}, Case{0.01, 0.05, 40000, true, 2},
                        Case{0.03, 0.3, 1e5, false, 3}, Case{0.1, 0.02, 1e5, true, 4},
                        Case{0.3, 0.5, 1e5, false, 5}, Case{0.02, 0.05, 150000, true, 6}}) {
    GraphOptions o = dripping();
    o.run_out = true;
    o.girth = c.girth, o.oldest = c.oldest, o.seed = c.seed, o.spacing = 0.25;
    o.interval = c.seed % 2 == 0 ? 5 : 100;
    if (c.jointed) o.planes = joints();
    const FormOptions forms{.girth = c.girth,
                            .tip = c.tip,
                            .stalagmites = 1,
                            .broken = 0.4,
                            .age = c.oldest,
                            .final_age = c.oldest,
                            .seed = c.seed};
    const Dripstone grown = grow_dripstone(rock, build_graph(rock, o),
                                           {o, forms, {.share = 1, .tip = c.tip, .floor = -3}, {}});
    ASSERT_GT(grown.forms.size(), 5u) << c.seed;
    const Box3d bounds = dripstone_bounds(rock.bounds(), o, forms), real = grown.solids.bounds();
    EXPECT_TRUE(bounds.intersects(real.min) && bounds.intersects(real.max))
        << c.seed << " " << real.min << real.max << " " << bounds.min << bounds.max;
    EXPECT_GE(grown.solids.node()->traits().growth_rate(), kDripstoneGrowth) << c.seed;
    RandomStream random(RandomKey(c.seed));
    for (int i = 0; i < 3000; ++i) {
      const double x = random.uniform(-12, 12), y = random.uniform(-12, 12);
      const Vec3d p(x, y, random.uniform(-12, 12));
      Vec3d away;
      for (int axis = 0; axis < 3; ++axis)
        away[axis] = std::max({bounds.min[axis] - p[axis], p[axis] - bounds.max[axis], 0.0});
      if (away.length() > 0) {
        ASSERT_GE(grown.solids.value(p), kDripstoneGrowth * away.length()) << c.seed;
      }
    }
  }
  // A box of 6 m, of which forms of 4 cm tips leave less than three on each side.
  const Box3d near = dripstone_bounds(rock.bounds(), dripping(), {.tip = 0.02});
  EXPECT_LT(near.size().x, 6 + 2 * 2.8);
  EXPECT_LT(near.size().y, 6 + 2 * 2.8);
}

TEST(Dripstone, IsTheSameForAnyNumberOfThreads) {
  const field::Field rock = cave();
  std::vector<double> first;
  for (const int threads : {1, 2, 7}) {
    const Dripstone grown = with_threads(threads, [&] {
      return grow_dripstone(rock, build_graph(rock, dripping()),
                            {dripping(), {.tip = 0.01}, {}, {}});
    });
    std::vector<double> values;
    RandomStream random(RandomKey(3));
    for (int i = 0; i < 500; ++i) {
      const Vec3d p(random.uniform(-3, 3), random.uniform(-2.2, 2.2), random.uniform(-3, 3));
      values.push_back(grown.solids.value(p));
      values.push_back(grown.thickness.value(p));
    }
    if (first.empty()) first = values;
    EXPECT_EQ(values, first) << threads;
  }
}

}  // namespace
}  // namespace vug::drips
