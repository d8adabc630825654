// SPDX-License-Identifier: Apache-2.0
// Values that are not distances: the zero set is preserved, and the band gets first-order
// distances.
#include "solids.h"

#include <gtest/gtest.h>
#include <vug/field/noise.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace vug::volume {
namespace {

using field::Field;
using field::make;

TEST(Repair, ConcentricMorphIsASphere) {
  VoxelizeOptions options;
  options.voxel = 1.0 / 16;
  const double radius = 0.7 * 1 + 0.3 * 3;
  const LevelSet grid =
      voxelize(field::morph(make("sphere"), make("sphere", {{"radius", 3.0}}), 0.3), options);
  EXPECT_EQ(check(grid).fault, "");
  for (const Vec3d& axis : {Vec3d(1, 0, 0), Vec3d(0, -1, 0), Vec3d(0, 0, 1)})
    EXPECT_NEAR(crossing(grid, {0, 0, 0}, axis, 4), radius, 1e-4 * options.voxel);
  // The whole band is present, although values that are not distances may be missing far from any
  // surface.
  each_lattice_point(grid, [&](const Vec3d& p, double value) {
    const double distance = p.length() - radius, band = grid.background();
    if (std::fabs(distance) > band * 0.999) {
      EXPECT_GT(std::fabs(value), band * 0.998);
    } else {
      EXPECT_NEAR(value, distance, 1e-4 * options.voxel);
    }
  });
}

using Index = std::array<int, 3>;

/// Lattice steps, each along any of the axes at once, from the active points next to a change of
/// sign; for points within `most` steps.
std::map<Index, int> steps_to_surface(const std::map<Index, double>& values, double background,
                                      int most) {
  std::map<Index, int> steps;
  std::vector<Index> front;
  for (const auto& [at, value] : values)
    for (size_t side = 0; side < 6 && std::fabs(value) < background; ++side) {
      Index next = at;
      next[side / 2] += side % 2 ? 1 : -1;
      const auto other = values.find(next);
      if (other != values.end() && (other->second < 0) != (value < 0) &&
          steps.emplace(at, 0).second)
        front.push_back(at);
    }
  for (int step = 1; step <= most; ++step) {
    std::vector<Index> next;
    for (const Index& at : front)
      for (int n = 0; n < 27; ++n) {
        const Index near{at[0] + n / 9 - 1, at[1] + n / 3 % 3 - 1, at[2] + n % 3 - 1};
        if (steps.emplace(near, step).second) next.push_back(near);
      }
    front = std::move(next);
  }
  return steps;
}

TEST(Repair, TheBandEndsNearTheSurface) {
  // Where the noise is steep, v / |grad v| is also small deep in the rock.
  const Value noise =
      field::as_value(field::make_noise("ridged", {{"scale", 0.12}, {"octaves", 5}}));
  const Value ball = field::as_value(make("sphere"));
  const Field rough = make("displace", {{"field", ball}, {"noise", noise}, {"amount", 0.4}});
  VoxelizeOptions options;
  options.voxel = 1.0 / 8;
  for (const double half_width : {3.0, 4.5, 8.0}) {
    options.half_width = half_width;
    const LevelSet grid = voxelize(rough, options);
    EXPECT_EQ(check(grid).fault, "");
    std::map<Index, double> held;
    each_lattice_point(grid, [&](const Vec3d& p, double value) {
      held[{static_cast<int>(std::lround(p.x / options.voxel)),
            static_cast<int>(std::lround(p.y / options.voxel)),
            static_cast<int>(std::lround(p.z / options.voxel))}] = value;
      // No sign is lost or created.
      const double exact = rough.value(p);
      EXPECT_TRUE(std::fabs(exact) < 1e-6 || (value < 0) == (exact < 0));
    });
    const int most = static_cast<int>(std::ceil(half_width)) + 1;
    const auto steps = steps_to_surface(held, grid.background(), most);
    size_t beyond = 0, last = 0;
    for (const auto& [at, value] : held) {
      if (std::fabs(value) >= grid.background()) continue;
      const auto found = steps.find(at);
      beyond += found == steps.end() ? 1 : 0;
      last += found != steps.end() && found->second == most ? 1 : 0;
    }
    EXPECT_EQ(beyond, 0u) << half_width;
    EXPECT_GT(last, 100u) << half_width;  // Not trimmed more than it must be.
  }
}

// Half-way between two balls of radius R at distance D is the prolate ellipsoid with their centres
// as foci: semi-axes R along and sqrt(R^2 - D^2/4) across.
TEST(Repair, MorphOfTwoBallsIsTheEllipsoid) {
  for (const double separation : {2.0, 10.0, 50.0, 200.0}) {
    const double focus = separation / 2, along = 0.75 * separation + 20;  // In voxels.
    const double across = std::sqrt(along * along - focus * focus);
    VoxelizeOptions options;
    options.voxel = 1;
    const LevelSet grid = voxelize(
        field::morph(sphere_at({focus, 0, 0}, along), sphere_at({-focus, 0, 0}, along), 0.5),
        options);
    EXPECT_EQ(check(grid).fault, "");
    for (const double angle : {0.0, 0.3, 0.8, 1.2, 1.57079632679})
      for (const double turn : {0.0, 0.7}) {
        const double c = std::cos(angle), s = std::sin(angle);
        const Vec3d direction(c, s * std::cos(turn), s * std::sin(turn));
        const double exact = 1 / std::sqrt(c * c / (along * along) + s * s / (across * across));
        // Along a ray, trilinear cells bend the surface by their curvature, h^2 / 8 r.
        const double bend = 0.5 / across;
        EXPECT_NEAR(crossing(grid, {0, 0, 0}, direction, 2 * along), exact, 0.02 + bend)
            << separation << " " << angle;
      }
  }
}

TEST(Repair, DistantBallsHaveAnEmptyMorph) {
  VoxelizeOptions options;
  options.voxel = 0.1;
  const LevelSet grid =
      voxelize(field::morph(sphere_at({1.5, 0, 0}, 1), sphere_at({-1.5, 0, 0}, 1), 0.5), options);
  each_lattice_point(grid, [](const Vec3d&, double value) { EXPECT_GT(value, 0); });
}

/// Distance to the field's zero set by descent from p.
double distance(const Field& field, const Vec3d& p) {
  Vec3d q = p;
  for (int i = 0; i < 200; ++i) {
    const field::Gradient g = field.gradient(q);
    const double squared = g.gradient.length2();
    q -= g.gradient * (g.value / squared);
    // Slides along the surface towards p.
    const Vec3d normal = field.gradient(q).gradient.normalized();
    const Vec3d offset = p - q;
    q += (offset - normal * offset.dot(normal)) * 0.5;
  }
  const field::Gradient g = field.gradient(q);
  q -= g.gradient * (g.value / g.gradient.length2());
  return (p - q).length();
}

TEST(Repair, SteepFieldsBecomeDistances) {
  // An ellipsoid as a bound: |p / axes| - 1 has slopes from 1/2 to 2.
  const Field squashed =
      field::morph(sphere_at({0.4, 0, 0}, 1), sphere_at({-0.4, 0.1, 0}, 0.8), 0.5);
  VoxelizeOptions options;
  options.voxel = 1.0 / 24;
  const LevelSet grid = voxelize(squashed, options);
  double worst = 0;
  each_lattice_point(grid, [&](const Vec3d& p, double value) {
    if (std::fabs(value) > 2 * options.voxel || (Vec3i(p * 24).x & 3)) return;
    worst = std::max(worst, std::fabs(std::fabs(value) - distance(squashed, p)));
  });
  // First order: the remainder is d^2 times curvature (about 1 / m) over 2, at d of 2 voxels.
  EXPECT_LT(worst, 2 * options.voxel * 2 * options.voxel);
  EXPECT_LT(check(grid).share_off_unit_slope, 0.001);
}

TEST(Repair, ReachesEveryPointOfTheBand) {
  // Steep and shallow slopes in one solid; a skipped point would keep the background's value.
  const Field solid = field::morph(
      sphere_at({0.7, 0, 0}, 1),
      field::unite({sphere_at({-0.6, 0.3, 0.2}, 0.8), sphere_at({0, -1, 0.5}, 0.5)}), 0.45);
  VoxelizeOptions options;
  options.voxel = 1.0 / 32;
  const LevelSet grid = voxelize(solid, options);
  int active = 0;
  each_lattice_point(grid, [&](const Vec3d& p, double value) {
    const field::Gradient g = solid.gradient(p);
    const double slope = g.gradient.length();
    if (slope < 0.05)
      return;  // Hardly a direction: such values stay inside the band intentionally.
    const Vec3d aside(1e-5, -7e-6, 4e-6);
    if ((solid.gradient(p + aside).gradient - solid.gradient(p - aside).gradient).length() > 1e-3)
      return;  // On a crease the slope of either side is correct.
    const double expected = std::clamp(g.value / slope, -grid.background(), grid.background());
    ASSERT_NEAR(value, expected, 2e-3 * options.voxel) << p;
    active += std::fabs(expected) < grid.background();
  });
  EXPECT_GT(active, 40000);
}

TEST(Repair, KeepsEverySign) {
  VoxelizeOptions repaired, raw;
  repaired.voxel = raw.voxel = 1.0 / 24;
  raw.repair = false;
  const Field solid = lumpy_solid();
  for (const VoxelizeOptions& options : {repaired, raw}) {
    const LevelSet grid = voxelize(solid, options);
    EXPECT_EQ(check(grid).fault, "");
    each_lattice_point(grid, [&](const Vec3d& p, double value) {
      const double truth = solid.value(p);
      EXPECT_TRUE(std::fabs(truth) < 1e-6 || (value < 0) == (truth < 0));
    });
  }
}

}  // namespace
}  // namespace vug::volume
