// SPDX-License-Identifier: Apache-2.0
// Sheets of triangles, and the draperies made of them.
#include <vug/base/rng.h>
#include <vug/field/path.h>
#include <vug/field/speleothems/drapery_sheet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// Two triangles in the plane y = 0, of half a thickness 0.1.
Sheet square() {
  return {
      {Vec3d(0, 0, 0), Vec3d(0, 0, 1), Vec3d(2, 0, 0), Vec3d(2, 0, 1)}, {0.1, 0.1, 0.1, 0.1}, 2};
}

TEST(Sheet, OfEqualThicknessIsTheDistanceToARectangle) {
  const Field sheet = sheet_field("sheet", square());
  RandomStream random(RandomKey(4));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p(random.uniform(-1, 3), random.uniform(-1, 1), random.uniform(-1, 2));
    const Vec3d away(std::max({-p.x, p.x - 2, 0.0}), p.y, std::max({-p.z, p.z - 1, 0.0}));
    EXPECT_NEAR(sheet.value(p), away.length() - 0.1, 1e-9);
  }
}

TEST(Sheet, KeepsItsLipschitzConstantAndItsRestrictions) {
  Sheet uneven = square();
  uneven.radii = {0.05, 0.2, 0.1, 0.15};
  uneven.corners[3].y = 0.4;
  const Field sheet = sheet_field("sheet", uneven);
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p(random.uniform(-1, 3), random.uniform(-1, 1), random.uniform(-1, 2));
    const Vec3d q =
        p + Vec3d(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
    EXPECT_LE(std::fabs(sheet.value(p) - sheet.value(q)),
              sheet.lipschitz() * (p - q).length() + 1e-12);
    const Ball ball{p, (p - q).length() * 1.01};
    EXPECT_NEAR(sheet.restricted(ball).field.value(q), sheet.value(q), 1e-12);
  }
}

// Folds vary the thickness, but no value is below the distance from the bounds.
TEST(Sheet, GrowsWithTheDistanceFromItsBounds) {
  Sheet uneven = square();
  uneven.radii = {0.3, 0.05, 0.9, 0.1};
  uneven.corners[3].y = 0.4;
  const Field sheet = sheet_field("sheet", uneven);
  ASSERT_GT(sheet.lipschitz(), 1.5);
  EXPECT_EQ(sheet.node()->traits().growth_rate(), 1);
  const Box3d& box = sheet.bounds();
  RandomStream random(RandomKey(6));
  int outside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-3, 5), y = random.uniform(-3, 3);
    const Vec3d p(x, y, random.uniform(-3, 4));
    Vec3d away;
    for (int axis = 0; axis < 3; ++axis)
      away[axis] = std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0});
    outside += away.length() > 0 ? 1 : 0;
    ASSERT_GE(sheet.value(p), away.length() > 0 ? away.length() - 1e-12 : -0.9) << p;
  }
  EXPECT_GT(outside, 1000);
}

Drapery level_path(double length) {
  return {{Vec3d(0, 0, 0), Vec3d(length, -0.3 * length, 0)}, 0.5, 0.006, 0.014, 0.1, 0};
}

TEST(DraperySheet, HasTheThicknessOfADropAtItsEdge) {
  const Drapery drapery = level_path(1.5);
  const Sheet sheet = drapery_sheet(drapery, RandomKey(1));
  const auto across = static_cast<size_t>(sheet.across);
  for (size_t row = 0; row < sheet.corners.size(); row += across) {
    const double width = sheet.corners[row].y - sheet.corners[row + across - 1].y;
    EXPECT_LE(width, drapery.width + 1e-9);
    if (width > 0.7 * drapery.width) {
      EXPECT_NEAR(sheet.radii[row + across - 1], 0.003, 1e-9);
    }
    EXPECT_NEAR(sheet.radii[row], 0.007, 1e-9) << "the root";
  }
}

TEST(DraperySheet, FoldsSwingAtTheirDistanceAndNotAtTheRoot) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Drapery drapery = level_path(2);
    const Sheet sheet = drapery_sheet(drapery, RandomKey(seed));
    const auto across = static_cast<size_t>(sheet.across);
    int crossings = 0;
    double last = 0, swing = 0;
    for (size_t row = 0; row < sheet.corners.size(); row += across) {
      EXPECT_NEAR(sheet.corners[row].z, 0, 1e-12) << "the root keeps to the path";
      const double z = sheet.corners[row + across - 1].z;
      swing = std::max(swing, std::fabs(z));
      if (z * last < 0) ++crossings;
      if (z != 0) last = z;
    }
    const double folds = path_length(drapery.path) / drapery.fold;
    EXPECT_NEAR(0.5 * crossings, folds, 0.2 * folds) << seed;
    EXPECT_NEAR(swing, 0.25 * drapery.fold, 0.25 * 0.25 * drapery.fold);
  }
}

TEST(DraperySheet, WithoutFoldsIsPlane) {
  Drapery drapery = level_path(1);
  drapery.fold = 0;
  for (const Vec3d& corner : drapery_sheet(drapery, RandomKey(1)).corners) EXPECT_EQ(corner.z, 0);
}

TEST(Resampled, KeepsTheEndsAndTheSteps) {
  const std::vector<Vec3d> bent = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, -1, 0),
                                   Vec3d(1, -1, 2)};
  const std::vector<Vec3d> points = resampled(bent, 0.25);
  ASSERT_EQ(points.size(), 17u);
  EXPECT_EQ(points.front(), bent.front());
  EXPECT_NEAR((points.back() - bent.back()).length(), 0, 1e-12);
  for (size_t i = 1; i < points.size(); ++i)
    EXPECT_NEAR((points[i] - points[i - 1]).length(), 0.25, 1e-9);
}

}  // namespace
}  // namespace vug::field
