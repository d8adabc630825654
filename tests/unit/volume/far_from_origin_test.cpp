// SPDX-License-Identifier: Apache-2.0
// Bricks are evaluated relative to themselves: a level set is as accurate kilometres from the
// origin as at the origin, and the same solid has the same bricks wherever it is.
#include "solids.h"

#include <vug/field/displace.h>
#include <vug/volume/bricks.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

using field::Field;
using field::make;

constexpr double kVoxel = 1.0 / 32;  // Dyadic, so that the coordinates of moved bricks are exact.

Field moved(const Field& field, const Vec3d& by) {
  return field::transformed(field, Transform::translation(by));
}

/// Whole bricks, up to 5 km from the origin.
const std::vector<Vec3i> kSteps = {{1, 0, 0}, {-3, 7, 1000}, {720, -711, 730}};

/// Solids whose parts are all moved in double precision.
std::vector<std::pair<std::string, Field>> exact_solids() {
  const Transform turned =
      Transform::translation({0.3, 0.2, -0.1}) * Transform::rotation({1, 2, 0.5}, 0.7);
  const Field ball = sphere_at({0.4, 0.1, 0.2}, 0.7),
              box = make("box", {{"size", Vec3d(1.1, 0.8, 0.7)}}),
              rod = make("capsule",
                         {{"a", Vec3d(-1, 0.2, 0)}, {"b", Vec3d(1.2, -0.3, 0.4)}, {"radius", 0.3}});
  return {
      {"box on the lattice", make("box", {{"size", Vec3d(1, 1, 1)}})},
      {"turned box", field::transformed(box, turned)},
      {"rod", rod},
      {"stretched", field::transformed(ball, Transform::scaling({1, 2, 0.5}))},
      {"difference", field::subtract(box, {ball, rod})},
      {"blend", field::unite({ball, box, rod}, {field::Profile::smooth, 0.2})},
      {"morph", lumpy_solid()},
      {"half", field::intersect({box, make("half_space", {{"offset", 0.1}})})},
  };
}

TEST(FarFromOrigin, TheSameSolidHasTheSameBricks) {
  for (const auto& [name, solid] : exact_solids()) {
    const auto here = brick_digests(voxelize(solid, with_voxel(kVoxel)));
    for (const Vec3i& step : kSteps) {
      const Vec3d by = Vec3d(step * kBrickEdge) * kVoxel;
      std::map<BrickOrigin, Digest> back;
      for (const auto& [at, digest] : brick_digests(voxelize(moved(solid, by), with_voxel(kVoxel))))
        back[{at[0] - step.x * kBrickEdge, at[1] - step.y * kBrickEdge,
              at[2] - step.z * kBrickEdge}] = digest;
      EXPECT_EQ(back, here) << name << " moved by " << by;
    }
  }
}

// Regions cut solids where they are.
TEST(FarFromOrigin, RegionsMoveWithTheSolid) {
  const Vec3d by = Vec3d(720, -711, 730) * kBrickEdge * kVoxel;
  VoxelizeOptions here = with_voxel(kVoxel), there = here;
  here.region = Box3d({-0.4, -0.3, -0.2}, {0.3, 0.4, 0.5});
  there.region = Box3d(here.region->min + by, here.region->max + by);
  const auto one = brick_digests(voxelize(lumpy_solid(), here)),
             other = brick_digests(voxelize(moved(lumpy_solid(), by), there));
  ASSERT_EQ(one.size(), other.size());
  for (auto a = one.begin(), b = other.begin(); a != one.end(); ++a, ++b)
    EXPECT_EQ(a->second, b->second);
}

// Distances differ from those in double precision by the rounding of coordinates in one brick.
TEST(FarFromOrigin, DistancesAreAsAccurateAsNear) {
  constexpr double kBrickRounding = 4 * 64 * 0x1p-24;  // In voxels.
  for (const double far : {0.0, 5000.0}) {
    const Vec3d by(far, -0.7 * far, 0.3 * far);
    const VoxelizeOptions options = with_voxel(0.02);
    const Field solid = moved(field::unite({sphere_at({0.4, 0.1, 0.2}, 0.5),
                                            make("box", {{"size", Vec3d(1.1, 0.8, 0.7)}})}),
                              by);
    const LevelSet grid = voxelize(solid, options);
    double worst = 0;
    each_lattice_point(grid, [&](const Vec3d& p, double value) {
      const double limit = grid.background();
      const double expected = std::max(-limit, std::min(limit, solid.value(p)));
      worst = std::max(worst, std::fabs(value - expected));
    });
    // The grid's own coordinates have this error in double precision.
    EXPECT_LE(worst, kBrickRounding * options.voxel + 1e-11) << far;
  }
}

// Noises are evaluated at absolute points, which single precision rounds: values differ by at most
// this rounding times the slope.
TEST(FarFromOrigin, NoisesDifferByTheRoundingOfPoints) {
  const Vec3d by(3000, -2500, 4000);
  const Field solid = field::displaced(
      sphere_at(by, 0.8), field::make_noise("fbm", {{"scale", 0.5}}), field::Displacement());
  VoxelizeOptions options = with_voxel(0.02);
  options.repair = false;
  const LevelSet grid = voxelize(solid, options);
  const double rounding = 4000 * 0x1p-24 * std::sqrt(3.0);
  double worst = 0;
  each_lattice_point(grid, [&](const Vec3d& p, double value) {
    const double limit = grid.background(), exact = solid.value(p);
    if (std::fabs(exact) < 0.9 * limit) worst = std::max(worst, std::fabs(value - exact));
  });
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, 2 * solid.lipschitz() * rounding);
}

}  // namespace
}  // namespace vug::volume
