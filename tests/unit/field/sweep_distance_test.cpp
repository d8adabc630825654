// SPDX-License-Identifier: Apache-2.0
// Values as distances: exact ones equal the distance to the surface, bounds never exceed it. Sphere
// tracing from all sides finds the surface.
#include "sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// Points of the surface: ends of rays from random points in random directions, `count` of them
/// unless few rays hit the surface.
std::vector<Vec3d> surface_points(const Field& field, RandomStream& random, size_t wanted) {
  const Box3d box = grown(probe_box(field), 0.1);
  std::vector<Vec3d> found;
  for (int ray = 0; ray < 20000 && found.size() < wanted; ++ray) {
    Vec3d p = box.center() + 0.5 * box.size() * random_point(random, 1);
    const Vec3d way = random_point(random, {Vec3d(0), 1}).normalized();
    for (int step = 0; step < 300; ++step) {
      const double value = field.value(p) / std::max(1.0, field.lipschitz());
      if (std::fabs(value) < 1e-9) {
        found.push_back(p);
        break;
      }
      if (p.length() > 20) break;
      p += way * std::fabs(value);
    }
  }
  return found;
}

TEST(Sweep, NoValueExceedsTheDistance) {
  for_each_case([&](const SweepCase& c) {
    if (c.field.exactness() == Exactness::sign) return;
    RandomStream random(RandomKey(31).at(c.label));
    const std::vector<Vec3d> surface = surface_points(c.field, random, 1000);
    if (!c.field.bounds().isEmpty() && c.field.exactness() == Exactness::exact) {
      EXPECT_GT(surface.size(), 50u) << c.label;
    }
    for (int i = 0; i < 300; ++i) {
      const Vec3d p = random_point(random, 2.5);
      double nearest2 = kInfinity;
      for (const Vec3d& s : surface) nearest2 = std::min(nearest2, (s - p).length2());
      ASSERT_LE(std::fabs(c.field.value(p)), std::sqrt(nearest2) + 1e-7) << c.label << " at " << p;
    }
  });
}

// Together with the test above this bounds an exact value from both sides: there is a surface point
// at the stated distance.
TEST(Sweep, ExactValuesReachTheSurface) {
  for_each_case([&](const SweepCase& c) {
    if (c.field.exactness() != Exactness::exact) return;
    RandomStream random(RandomKey(32).at(c.label));
    const Box3d around = probe_box(c.field);
    const Vec3d size = around.size();
    const Box3d box = grown(around, std::min({0.5, size.x, size.y, size.z}));
    int inside = 0, lost = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3d p = box.center() + 0.5 * box.size() * random_point(random, 1);
      const Gradient g = c.field.gradient(p);
      const Vec3d foot = p - g.gradient * g.value;
      inside += c.field.value(foot - g.gradient * 1e-5) < 0;  // Thin walls, too.
      // If several points are equally near (the medial axis) the gradient may not be a direction.
      if (std::fabs(g.gradient.length() - 1) > 1e-6 || std::fabs(c.field.value(foot)) > 1e-6)
        ++lost;
    }
    EXPECT_LE(lost, 2) << c.label;
    EXPECT_GT(inside, 5) << c.label;
  });
}

}  // namespace
}  // namespace vug::field
