// SPDX-License-Identifier: Apache-2.0
// Scallops: their profile, length and lean on planes along the flow, and the velocity of the water.
#include <vug/field/displace.h>
#include <vug/field/noise.h>
#include <vug/field/speleogens/scallop_length.h>
#include <vug/field/speleogens/scallop_pits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::field {
namespace {

TEST(ScallopProfile, HasTheMeasuredDepthAndSlopes) {
  EXPECT_NEAR(scallop_profile(kScallopDeepest), 0.12533, 1e-5);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = (i + 0.5) / 1000;
    EXPECT_LT(scallop_profile(x), kScallopDepth);
    sum += scallop_profile(x) / 1000;
  }
  EXPECT_NEAR(sum, 0.07045, 1e-5);
  const double degree = 3.14159265358979 / 180;
  EXPECT_NEAR((scallop_profile(1e-6) - scallop_profile(-1e-6)) / 2e-6, std::tan(26.1 * degree),
              1e-3);
  EXPECT_NEAR((scallop_profile(1 + 1e-6) - scallop_profile(1 - 1e-6)) / 2e-6,
              -std::tan(7.87 * degree), 1e-3);
}

TEST(ScallopLength, HasTheVelocitiesOfCurl) {
  struct {
    double length, diameter, velocity;
  } const table[] = {{0.01, 0.5, 3.94}, {0.02, 1, 1.97},  {0.03, 1, 1.22},   {0.05, 0.5, 0.556},
                     {0.05, 1, 0.656},  {0.05, 2, 0.756}, {0.05, 10, 0.987}, {0.1, 5, 0.394},
                     {0.2, 1, 0.114},   {0.5, 2, 0.042},  {0.5, 10, 0.066}};
  for (const auto& row : table) {
    const double rounding = row.velocity < 0.1 ? 5.1e-4 : row.velocity < 1 ? 6e-4 : 6e-3;
    EXPECT_NEAR(scallop_velocity(row.length, row.diameter), row.velocity, rounding) << row.length;
    const double exact = scallop_velocity(row.length, row.diameter);
    EXPECT_NEAR(*scallop_length(exact, row.diameter), row.length, 1e-9);
  }
  EXPECT_FALSE(scallop_length(1e-4, 1));
}

/// Points of a plane: `n` along the flow for each of `m` across it.
struct Grid {
  Vec3d at, flow, across;
  int n, m;
  double step, step_across;
};

/// The depths of a scalloped wall below the plane of a grid.
struct Wall {
  Grid grid;
  std::vector<double> depth;

  double at(int along, int across) const {
    return depth[static_cast<size_t>(along * grid.m + across)];
  }
};

/// The wall that a displacement by `noise` makes of the plane: the heights h = amount noise(p + h
/// normal) over its points p, by iteration.
Wall wall(const Noise& noise, double amount, const Grid& grid) {
  const Vec3d normal = grid.flow.cross(grid.across);
  Wall out{grid, std::vector<double>(static_cast<size_t>(grid.n * grid.m))};
  std::vector<Vec3f> points(out.depth.size());
  for (int iteration = 0; iteration < 12; ++iteration) {
    for (int i = 0; i < grid.n; ++i)
      for (int j = 0; j < grid.m; ++j) {
        const auto k = static_cast<size_t>(i * grid.m + j);
        points[k] = Vec3f(grid.at + grid.flow * (i * grid.step) +
                          grid.across * (j * grid.step_across) - normal * out.depth[k]);
      }
    const std::vector<float> values = sample(noise.field, points);
    for (size_t k = 0; k < values.size(); ++k)
      out.depth[k] = -amount * static_cast<double>(values[k]);
  }
  return out;
}

struct Hollow {
  double length, depth, steepest_up, steepest_down, mean_up, mean_down;
};

/// Hollows around each local maximum of the depth, measured along the flow from crest to crest.
std::vector<Hollow> hollows(const Wall& w) {
  std::vector<Hollow> out;
  for (int i = 2; i < w.grid.n - 2; ++i)
    for (int j = 2; j < w.grid.m - 2; ++j) {
      bool deepest = true;
      for (int k = 0; k < 25; ++k) deepest &= w.at(i + k / 5 - 2, j + k % 5 - 2) <= w.at(i, j);
      if (!deepest) continue;
      int a = i, b = i;
      Hollow h{};
      for (; a > 0 && w.at(a - 1, j) < w.at(a, j); --a)
        h.steepest_up = std::max(h.steepest_up, (w.at(a, j) - w.at(a - 1, j)) / w.grid.step);
      for (; b < w.grid.n - 1 && w.at(b + 1, j) < w.at(b, j); ++b)
        h.steepest_down = std::max(h.steepest_down, (w.at(b, j) - w.at(b + 1, j)) / w.grid.step);
      if (a == 0 || b == w.grid.n - 1 || a == i || b == i) continue;
      h.length = (b - a) * w.grid.step;
      for (int k = a; k <= b; ++k)
        h.depth = std::max(h.depth,
                           w.at(k, j) - w.at(a, j) - (w.at(b, j) - w.at(a, j)) * (k - a) / (b - a));
      h.mean_up = (w.at(i, j) - w.at(a, j)) / ((i - a) * w.grid.step);
      h.mean_down = (w.at(i, j) - w.at(b, j)) / ((b - i) * w.grid.step);
      out.push_back(h);
    }
  return out;
}

struct Statistics {
  double sauter, relative_depth, upstream, variation;
  size_t count;
};

Statistics statistics(const std::vector<Hollow>& all) {
  double sum = 0, squares = 0, cubes = 0, depth = 0, upstream = 0;
  const double n = static_cast<double>(all.size());
  for (const Hollow& h : all) {
    sum += h.length / n;
    squares += h.length * h.length / n;
    cubes += h.length * h.length * h.length / n;
    depth += h.depth / h.length / n;
    upstream += (h.mean_up > h.mean_down) / n;
  }
  return {cubes / squares, depth, upstream, std::sqrt(squares / sum / sum - 1), all.size()};
}

TEST(Scallops, HaveTheLengthDepthAndLeanOfRealOnesOnWallsOfAnyDirection) {
  const Vec3d flow = Vec3d(3, 0.4, 1).normalized();
  const double size = 0.4;
  const Noise noise = make_noise("scallops", {{"size", size}, {"flow", flow}, {"seed", 3}});
  for (const Vec3d& hint : {Vec3d(0, 1, 0), Vec3d(0, 0, 1), Vec3d(0.3, 1, 1)}) {
    const Vec3d across = flow.cross(hint).normalized();
    const Statistics s = statistics(hollows(
        wall(noise, size / 8, {{3.1, -2, 5}, flow, across, 300, 300, size / 30, size / 30})));
    EXPECT_GT(s.count, 100u);
    EXPECT_NEAR(s.sauter / size, 1, 0.1) << hint;
    EXPECT_GT(s.relative_depth, 0.11) << hint;
    EXPECT_LT(s.relative_depth, 0.13) << hint;
    EXPECT_GT(s.upstream, 0.65) << hint;
    EXPECT_NEAR(s.variation, 0.3, 0.08) << hint;
  }
}

TEST(Scallops, DefaultsOfDisplaceAndScallopsMakeRealOnes) {
  const Displacement defaults;
  const Statistics s =
      statistics(hollows(wall(*default_noise("scallops"), defaults.amount,
                              {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 300, 300, 0.8 / 30, 0.8 / 30})));
  EXPECT_GT(s.relative_depth, 0.11);
  EXPECT_LT(s.relative_depth, 0.13);
}

// Within a twentieth of the length around a crest, nearly all of the turn happens at the crest.
TEST(Scallops, MeetInSharpCrests) {
  const Wall w = wall(make_noise("scallops", {{"size", 1}}), 0.125,
                      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5000, 20, 1.0 / 1000, 0.3});
  int crests = 0, sharp = 0;
  for (int j = 0; j < w.grid.m; ++j)
    for (int i = 25; i < w.grid.n - 25; ++i) {
      if (w.at(i, j) > w.at(i - 1, j) || w.at(i, j) > w.at(i + 1, j)) continue;
      ++crests;
      auto turn = [&](int reach) { return w.at(i + reach, j) + w.at(i - reach, j); };
      const double within = turn(25) - turn(0), beyond = turn(25) - turn(3);
      sharp += beyond < 0.93 * within;  // 0.88 for an edge, 0.986 for a parabola
    }
  EXPECT_GT(crests, 50);
  EXPECT_GT(sharp, 0.9 * crests);
}

TEST(Scallops, FlutesAreWiderThanLong) {
  const Wall w = wall(make_noise("scallops", {{"size", 0.4}, {"ratio", 4}}), 0.05,
                      {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 300, 300, 0.02, 0.02});
  int along = 0, across = 0;  // Crests on lines in both directions.
  for (int i = 1; i < 299; ++i)
    for (int j = 1; j < 299; ++j) {
      const double here = w.at(i, j);
      along += here < w.at(i - 1, j) && here < w.at(i + 1, j);
      across += here < w.at(i, j - 1) && here < w.at(i, j + 1);
    }
  EXPECT_GT(along, 2.5 * across);
  EXPECT_GT(across, 100);
}

TEST(Scallops, VelocityReplacesTheSize) {
  const double length = *scallop_length(0.66, 1);
  EXPECT_NEAR(length, 0.05, 0.001);
  const Noise a = make_noise("scallops", {{"velocity", 0.66}, {"diameter", 1.0}}),
              b = make_noise("scallops", {{"size", length}});
  for (int i = 0; i < 100; ++i) {
    const Vec3d p(0.013 * i, 0.02 * i, -0.007 * i);
    EXPECT_EQ(a.field.value(p), b.field.value(p));
  }
  EXPECT_THROW(make_noise("scallops", {{"velocity", 0.001}, {"diameter", 0.2}}), std::exception);
}

}  // namespace
}  // namespace vug::field
