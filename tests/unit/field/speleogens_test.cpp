// SPDX-License-Identifier: Apache-2.0
// Forms of dissolution and erosion: measured widths, depths and directions.
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/displace.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/field/speleogens/plan_columns.h>
#include <vug/field/speleogens/roofs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace vug::field {
namespace {

double at(const Noise& noise, const Vec3d& p) { return noise.field.value(p); }

struct Extremes {
  int count = 0;                  ///< The number of maxima.
  double maxima = 0, minima = 0;  ///< Means.
};

/// The extremes of a function on [0, length], sampled `count` times.
Extremes extremes(double length, int count, const std::function<double(double)>& value) {
  Extremes out;
  std::vector<double> v;
  for (int i = 0; i < count; ++i) v.push_back(value(length * i / count));
  int minima = 0;
  for (size_t i = 1; i + 1 < v.size(); ++i) {
    if (v[i] > v[i - 1] && v[i] >= v[i + 1]) {
      ++out.count;
      out.maxima += v[i];
    }
    if (v[i] < v[i - 1] && v[i] <= v[i + 1]) {
      ++minima;
      out.minima += v[i];
    }
  }
  out.maxima /= out.count;
  out.minima /= minima;
  return out;
}

TEST(ShaftFlutes, ArePlumbAndAFifthAsDeepAsWide) {
  const double width = 0.4;
  const Noise flutes = make_noise("shaft_flutes", {{"width", width}, {"seed", 2}});
  for (int i = 0; i < 100; ++i) {
    const Vec3d p(0.37 * i, 0.3, 0.2 * i);
    EXPECT_NEAR(at(flutes, p), at(flutes, p + Vec3d(0, 8.8, 0)), 1e-12);
  }
  for (const Vec3d& way : {Vec3d(1, 0, 0), Vec3d(0, 0, 1), Vec3d(0.6, 0, 0.8)}) {
    const Extremes ribs =
        extremes(400, 40000, [&](double x) { return at(flutes, Vec3d(3, 1, 7) + way * x); });
    EXPECT_NEAR(400.0 / ribs.count, width, 0.1 * width) << way;
    // With an amount of width / 5.
    EXPECT_NEAR((ribs.maxima - ribs.minima) / 5, 0.2, 0.03) << way;
  }
}

TEST(SunCups, AreBowlsOfTheStatedWidth) {
  const double width = 0.4, step = 0.02;
  const Noise cups = make_noise("sun_cups", {{"width", width}});
  const int n = 300;
  std::vector<double> v;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) v.push_back(at(cups, {i * step, -3, j * step}));
  int bowls = 0;
  for (int i = 1; i < n - 1; ++i)
    for (int j = 1; j < n - 1; ++j) {
      bool least = true;
      for (int k = 0; k < 9; ++k)
        least &= v[static_cast<size_t>((i + k / 3 - 1) * n + j + k % 3 - 1)] >=
                 v[static_cast<size_t>(i * n + j)];
      bowls += least;
    }
  const double side = n * step;
  EXPECT_NEAR(std::sqrt(side * side / bowls), width, 0.25 * width);
}

TEST(Rillenkarren, LieSideBySideAndFadeDownhill) {
  const Noise rills = make_noise("rillenkarren", {{"width", 0.02},
                                                  {"length", 0.3},
                                                  {"downhill", Vec3d(1, -1, 0)},
                                                  {"crest", Vec3d(0.1, 2, 0)}});
  const Vec3d down = Vec3d(1, -1, 0).normalized();
  auto mean = [&](double metres) {
    double sum = 0;
    for (int i = 0; i < 20000; ++i)
      sum += at(rills, Vec3d(0.1, 2, 1e-3 * i) + down * metres) / 20000;
    return sum;
  };
  EXPECT_NEAR(mean(0), -2.0 / 3, 0.002);  // Parabolas without gaps between them.
  EXPECT_NEAR(mean(0.09), -2.0 / 3 * (1 - 0.09 / 0.3 * 1.06), 0.01);  // 1 / mean of 1 / length
  EXPECT_NEAR(mean(-0.09), mean(0.09), 1e-9);                         // Both sides of the crest.
  EXPECT_EQ(mean(0.43), 0);                                           // 1.4 lengths
  const Extremes ridges =
      extremes(20, 100000, [&](double z) { return at(rills, Vec3d(0.1, 2, z) + down * 0.05); });
  EXPECT_NEAR(20 / 0.02, ridges.count, 10);
}

TEST(Anastomoses, AreAsWideAsStatedAndFollowTheBeds) {
  const Vec3d normal = Vec3d(0.2, 1, -0.1).normalized();
  const double width = 0.2;
  const Noise tubes = make_noise("anastomoses", {{"normal", normal}, {"width", width}});
  RandomStream random(RandomKey(4));
  double open = 0, borders = 0;
  const int lines = 400, count = 1000;
  for (int line = 0; line < lines; ++line) {
    const Vec3d start(random.uniform(-90, 90), random.uniform(-5, 5), random.uniform(-90, 90));
    const Vec3d way =
        normal.cross(Vec3d(random.uniform(-1, 1), 0, random.uniform(-1, 1))).normalized();
    EXPECT_NEAR(at(tubes, start), at(tubes, start + 1.3 * normal), 1e-9);
    bool before = at(tubes, start) < 0;
    for (int i = 1; i <= count; ++i) {
      const bool here = at(tubes, start + way * (0.004 * i)) < 0;
      open += here;
      borders += here != before;
      before = here;
    }
  }
  // Chords of strips of this width in all directions are pi / 2 widths long on average; junctions
  // join some of them.
  const double chord = open * 0.004 / (0.5 * borders);
  EXPECT_GT(chord, 1.2 * width);
  EXPECT_LT(chord, 2.6 * width);
  EXPECT_LT(open / lines / count, 0.75);  // The rest are pendants.
}

TEST(WaterNotch, HasAFlatRoofAtEachLevelAndAFacetBelow) {
  const List levels{Value(1.0), Value(3.0)};
  const Noise notch = make_noise(
      "water_notch", {{"levels", levels}, {"height", 0.5}, {"roof", 0.1}, {"wander", 0.0}});
  for (const double level : {1.0, 3.0}) {
    EXPECT_NEAR(at(notch, {2, level, 7}), 0, 1e-12);
    EXPECT_NEAR(at(notch, {2, level - 0.05, 7}), -1, 1e-12);
    EXPECT_NEAR(at(notch, {2, level - 0.275, 7}), -0.5, 1e-12);  // A straight facet.
    EXPECT_NEAR(at(notch, {2, level - 0.5, 7}), 0, 1e-12);
    EXPECT_EQ(at(notch, {2, level + 0.3, 7}), 0);
  }
}

TEST(ColumnarJoints, HaveOneColumnForEachHexagonOfTheirWidth) {
  std::set<double> columns;
  const double side = 40;
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 60000; ++i) {
    const double x = random.uniform(0, side), y = random.uniform(0, side);
    const auto column = plan_column(x, y, 9);
    EXPECT_GE(column.inside(), 0);
    EXPECT_LT(std::hypot(column.other_x, column.other_y), 1.4);
    columns.insert(column.first_random);
  }
  EXPECT_NEAR(static_cast<double>(columns.size()) * std::sqrt(0.75), side * side,
              0.08 * side * side);
}

/// A room of 8 m x 3 m x 8 m, whose floor is at 0 and whose roof slopes by 1 in 4 along x.
Field room() {
  const Field air = intersect(
      {make("box", {{"size", Vec3d(8, 12, 8)}}), make("half_space", {{"normal", Vec3d(0, -1, 0)}}),
       make("half_space", {{"normal", Vec3d(-0.25, 1, 0)}, {"offset", 3 / std::sqrt(1.0625)}})});
  return complement(air);
}

RoofHollows hollows_of(const Field& rock, double spacing) {
  RoofHollows hollows;
  hollows.field = rock;
  hollows.from = {-3.5, -1, -3.5};
  hollows.to = {3.5, 7, 3.5};
  hollows.spacing = spacing;
  return hollows;
}

TEST(Roofs, ArePlacesOfTheRoofWithTheirClearance) {
  const std::vector<Roof> roofs = find_roofs(hollows_of(room(), 0.5));
  EXPECT_EQ(roofs.size(), 14u * 14u);
  for (const Roof& roof : roofs) {
    EXPECT_NEAR(roof.at.y, 3 + 0.25 * roof.at.x, 1e-6);
    EXPECT_NEAR(roof.clearance, roof.at.y, 1e-6);
  }
}

TEST(BellHoles, ArePlumbUnderASlopingRoof) {
  const Field rock = room();
  const RoofHollows where = hollows_of(rock, 2.4);
  const Field holed = make("bell_holes", {{"field", as_value(rock)},
                                          {"from", where.from},
                                          {"to", where.to},
                                          {"spacing", where.spacing},
                                          {"diameter", 0.6},
                                          {"height", 2.0}});
  EXPECT_GT(find_roofs(where).size(), 6u);
  for (const Roof& roof : find_roofs(where)) {
    EXPECT_GT(holed.value(roof.at + Vec3d(0, 0.5, 0)), 0.1);
    EXPECT_LT(holed.value(roof.at + Vec3d(0, 3.6, 0)), 0);
    EXPECT_LT(holed.value({roof.at.x, -0.05, roof.at.z}), 0);  // The floor remains.
    // The wall is equally far in all directions at both heights: a plumb cylinder.
    for (const double up : {0.3, 0.5}) {
      for (int k = 0; k < 8; ++k) {
        const Vec3d way(std::cos(k * 0.7854), 0, std::sin(k * 0.7854));
        const Vec3d p = roof.at + Vec3d(0, up, 0);
        EXPECT_GT(holed.value(p + 0.2 * way), 0);
      }
    }
  }
}

TEST(Cupolas, MeetInCuspsAndRiseAsStated) {
  const Field rock = room();
  const RoofHollows where = hollows_of(rock, 0.9);
  const Field domed = make("cupolas", {{"field", as_value(rock)},
                                       {"from", where.from},
                                       {"to", where.to},
                                       {"spacing", where.spacing},
                                       {"diameter", 1.5},
                                       {"rise", 0.8}});
  // The roof along a line: the highest air above each point.
  auto roof_at = [&](double x) {
    double low = 3 + 0.25 * x - 0.3, high = low + 3;
    for (int i = 0; i < 25; ++i) {
      const double middle = 0.5 * (low + high);
      (domed.value({x, middle, 0.2}) > 0 ? low : high) = middle;
    }
    return low - (3 + 0.25 * x);
  };
  std::vector<double> rise;
  for (int i = 0; i < 600; ++i) rise.push_back(roof_at(-3 + 0.01 * i));
  EXPECT_GT(*std::min_element(rise.begin(), rise.end()), -1e-6);
  const double highest = *std::max_element(rise.begin(), rise.end());
  EXPECT_GT(highest, 0.4);
  EXPECT_LT(highest, 0.75 * 1.42 * 0.8 * 1.2);
  int cusps = 0;  // The slope turns upwards within 1 cm on either side: an edge that points down.
  for (size_t i = 1; i + 1 < rise.size(); ++i)
    cusps += rise[i + 1] - 2 * rise[i] + rise[i - 1] > 0.4 * 0.01 && rise[i] > 0.01;
  EXPECT_GT(cusps, 2);
}

TEST(Pothole, IsUndercutAndItsGrooveIsASpiral) {
  const Field pit = make(
      "pothole",
      {{"diameter", 0.6}, {"depth", 1.5}, {"undercut", 1.3}, {"groove", 0.04}, {"pitch", 0.2}});
  auto radius = [&](double angle, double y) {
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (pit.value({middle * std::cos(angle), y, middle * std::sin(angle)}) < 0 ? low : high) =
          middle;
    }
    return low;
  };
  EXPECT_NEAR(radius(1, -1e-9), 0.3, 1e-4);  // The mouth is even.
  double widest = 0;
  for (int i = 0; i < 300; ++i) widest = std::max(widest, radius(0.4, -0.005 * i));
  EXPECT_GT(widest, 1.3 * 0.3 + 0.02);
  EXPECT_LT(widest, 1.3 * 0.3 + 0.045);
  EXPECT_LT(pit.value({0, -1.49, 0}), 0);
  EXPECT_GT(pit.value({0, -1.51, 0}), 0);
  // A quarter of a turn is a quarter of the pitch; half of the pitch is from groove to rib.
  const double y = -0.9;
  double groove = y, most = 0;
  for (int i = 0; i < 200; ++i)
    if (radius(0, y + 0.001 * i) > most) most = radius(0, groove = y + 0.001 * i);
  EXPECT_NEAR(radius(1.5707963, groove - 0.05), most, 0.01);
  EXPECT_LT(radius(0, groove - 0.1), most - 0.025);
}

}  // namespace
}  // namespace vug::field
