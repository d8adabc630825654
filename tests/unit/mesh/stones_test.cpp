// SPDX-License-Identifier: Apache-2.0
// Stones at rest: shapes, the linear programme of contacts, and beds on flat and rough ground.
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/stones/stone_bed.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

/// A ball stretched along its axes, 20 * 4^3 triangles.
Mesh cobble(const Vec3d& half) {
  Mesh mesh = sphere_mesh(Vec3d(0.0), 1, 3);
  for (Vec3f& p : mesh.positions) p = Vec3f(Vec3d(p) * half);
  return mesh;
}

/// A grid of triangles over a square with the given heights.
template <class Height>
Mesh ground_mesh(double half, int cells, const Height& height) {
  Mesh mesh;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const double x = half * (2.0 * i / cells - 1), z = half * (2.0 * j / cells - 1);
      mesh.positions.push_back(Vec3f(Vec3d(x, height(x, z), z)));
    }
  const auto n = static_cast<uint32_t>(cells);
  for (uint32_t i = 0; i < n; ++i)
    for (uint32_t j = 0; j < n; ++j) {
      const uint32_t at = i * (n + 1) + j;
      mesh.triangles.push_back({at, at + 1, at + n + 2});
      mesh.triangles.push_back({at, at + n + 2, at + n + 1});
    }
  return mesh;
}

/// The weights of a point in a triangle of the plan, all at least 0 if it is inside.
double least_weight(const std::array<Vec3d, 3>& t, const Vec3d& p) {
  const auto area = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  };
  const double whole = area(t[0], t[1], t[2]);
  return std::min(
      {area(p, t[1], t[2]) / whole, area(t[0], p, t[2]) / whole, area(t[0], t[1], p) / whole});
}

TEST(StoneShape, HasTheClosedFormOfABlock) {
  const StoneShape block = stone_shape(box_mesh(Box3d(Vec3d(1, 2, 3), Vec3d(1.4, 2.2, 3.6))));
  EXPECT_EQ(block.corners.size(), 8u);
  ASSERT_EQ(block.faces.size(), 6u);
  EXPECT_LT((block.centre - Vec3d(1.2, 2.1, 3.3)).length(), 1e-6);
  EXPECT_NEAR(block.diameter, std::cbrt(6 * 0.4 * 0.2 * 0.6 / kPi), 1e-6);
  EXPECT_NEAR(block.radius, Vec3d(0.2, 0.1, 0.3).length(), 1e-6);
  const auto tall = heights_at(block, StonePose{}, 0.15, -0.2);
  ASSERT_TRUE(tall);
  EXPECT_NEAR(tall->low, -0.1, 1e-6);
  EXPECT_NEAR(tall->high, 0.1, 1e-6);
  EXPECT_FALSE(heights_at(block, StonePose{}, 0.21, 0));
}

TEST(StoneShape, IsInsideTheHullByAFewPercent) {
  const Vec3d half(0.2, 0.1, 0.15);
  const StoneShape shape = stone_shape(cobble(half));
  EXPECT_NEAR(shape.diameter, 2 * std::cbrt(half.x * half.y * half.z), 0.01 * shape.diameter);
  for (const StoneShape::Face& face : shape.faces) {
    const double exact = (face.outward * half).length();  // support function of an ellipsoid
    EXPECT_LE(face.offset, exact + 1e-6);
    EXPECT_GT(face.offset, exact - 0.04 * shape.diameter);
  }
}

TEST(StoneShape, RefusesAnOpenSheet) {
  EXPECT_THROW(stone_shape(ground_mesh(1, 2, [](double, double) { return 0.0; })), Error);
}

TEST(SupportPlane, ThreeContactsAroundTheCentreCarryTheBody) {
  // The lower hull of the gaps at the origin, by exhaustive search.
  RandomStream random(RandomKey(7));
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Gap> gaps;
    for (int i = 0; i < 25; ++i)
      gaps.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 0.1), 0});
    const SupportPlane plane = support_plane(gaps, 1.5, 10);
    ASSERT_TRUE(plane.is_supported());
    for (const Gap& g : gaps)
      EXPECT_GE(g.height - plane.drop - plane.slope_x * g.x - plane.slope_z * g.z, -1e-9);
    double least = kInfinity;  // All triangles around the origin carry at least this high.
    for (size_t i = 0; i < gaps.size(); ++i)
      for (size_t j = 0; j < i; ++j)
        for (size_t k = 0; k < j; ++k) {
          const std::array<Vec3d, 3> t = {Vec3d(gaps[i].x, 0, gaps[i].z),
                                          Vec3d(gaps[j].x, 0, gaps[j].z),
                                          Vec3d(gaps[k].x, 0, gaps[k].z)};
          if (least_weight(t, Vec3d(0.0)) < 0) continue;
          const SupportPlane carried = support_plane({gaps[i], gaps[j], gaps[k]}, 1.5, 10);
          least = std::min(least, carried.drop);
        }
    EXPECT_NEAR(plane.drop, least, 1e-9);
  }
}

TEST(SupportPlane, LimitsTheSlope) {
  const SupportPlane plane = support_plane({{0.5, 0, 0, 0}}, 1, 0.1);
  EXPECT_FALSE(plane.is_supported());
  EXPECT_LE(std::hypot(plane.slope_x, plane.slope_z), 0.21);
  EXPECT_GT(plane.drop, 0);
}

TEST(StoneBed, ABlockLiesOnAFaceOfAFloor) {
  const Mesh floor = ground_mesh(2, 3, [](double, double) { return 0.25; });
  const Vec3d half(0.2, 0.08, 0.12);
  StoneBed bed(floor, {stone_shape(box_mesh(Box3d(-half, half)))}, {});
  for (int i = 0; i < 12; ++i) {
    const Vec3d at(-1.5 + i % 4, 0.25, -1 + i / 4);
    ASSERT_TRUE(
        bed.add(0, bed.shapes()[0].diameter, at, RandomKey(3).at(static_cast<uint64_t>(i))));
  }
  for (const BedStone& stone : bed.stones()) {
    const double height = stone.rest.pose.centre.y - 0.25;
    const double nearest =
        std::min({std::fabs(height - 0.2), std::fabs(height - 0.08), std::fabs(height - 0.12)});
    EXPECT_LT(nearest, 1e-4) << height;
  }
}

/// Rough ground with slopes of up to 25 degrees, with details as small as the stones.
double rough(double x, double z) {
  return 0.15 * std::sin(1.3 * x) * std::cos(1.7 * z) + 0.02 * std::sin(17 * x + 3 * z) +
         0.01 * std::sin(31 * z - 11 * x);
}

class Bed : public testing::Test {
 protected:
  static StoneBed laid(const Mesh& ground, int large, int small) {
    StoneBedOptions options;
    options.cell = 0.05;
    StoneBed bed(ground,
                 {stone_shape(cobble({1, 0.5, 0.8})), stone_shape(cobble({1, 0.8, 0.9})),
                  stone_shape(box_mesh(Box3d(Vec3d(-1, -0.4, -0.7), Vec3d(1, 0.4, 0.7))))},
                 options);
    for (int i = 0; i < large + small; ++i) {
      const RandomKey key = RandomKey(5).at(static_cast<uint64_t>(i));
      RandomStream random(key.at("place"));
      const double x = random.uniform(-1.6, 1.6), z = random.uniform(-1.6, 1.6);
      const double diameter = i < large ? random.uniform(0.15, 0.3) : random.uniform(0.02, 0.08);
      bed.add(random.below(3), diameter, {x, rough(x, z), z}, key);
    }
    return bed;
  }
};

TEST_F(Bed, NoStoneFloatsOrIsBuriedAndThreeContactsCarryEach) {
  const Mesh ground = ground_mesh(2, 80, rough);
  const StoneBed bed = laid(ground, 40, 400);
  EXPECT_GT(bed.stones().size(), 280u);  // The others fell on larger ones.
  size_t deep = 0;
  const StoneGround below(ground);
  for (size_t i = 0; i < bed.stones().size(); ++i) {
    const BedStone& stone = bed.stones()[i];
    const StoneShape& shape = bed.shapes()[stone.shape];
    const StonePose& pose = stone.rest.pose;
    const double radius = shape.radius * pose.scale;
    const GroundPatch patch =
        below.patch({pose.centre - Vec3d(2 * radius), pose.centre + Vec3d(2 * radius)});
    // The height of the ground and of earlier stones at a point of the plan.
    const auto top = [&](double x, double z) {
      double height = patch.floor(x, z);
      for (size_t j = 0; j < i; ++j) {
        const BedStone& other = bed.stones()[j];
        if (const auto own = heights_at(bed.shapes()[other.shape], other.rest.pose, x, z))
          height = std::max(height, own->high);
      }
      return height;
    };
    // Points of the underside on a fine grid: none is deep in the ground.
    double deepest = 0;
    for (int a = -20; a <= 20; ++a)
      for (int b = -20; b <= 20; ++b) {
        const double x = pose.centre.x + 0.05 * a * radius, z = pose.centre.z + 0.05 * b * radius;
        if (const auto own = heights_at(shape, pose, x, z))
          deepest = std::max(deepest, top(x, z) - own->low);
      }
    // Edges that cross edges are not tested, so a corner may sink in a little.
    EXPECT_LT(deepest, 0.15 * shape.diameter * pose.scale) << i;
    deep += deepest > 0.05 * shape.diameter * pose.scale;
    // Three contacts touch both the stone and what is below it, around the centre of mass.
    for (const Vec3d& contact : stone.rest.contacts) {
      double apart = std::fabs(contact.y - top(contact.x, contact.z));
      for (size_t j = 0; j < i; ++j) {  // points of the outline have no height
        const BedStone& other = bed.stones()[j];
        for (const Vec3d& probe : bed.shapes()[other.shape].probes)
          apart = std::min(
              apart, (other.rest.pose.centre + other.rest.pose.offset(probe) - contact).length());
      }
      EXPECT_LT(apart, 1e-6) << i;
      double gap = kInfinity;
      if (const auto own = heights_at(shape, pose, contact.x, contact.z))
        gap = own->low - contact.y;
      for (const Vec3d& probe : shape.probes) {
        const Vec3d p = pose.centre + pose.offset(probe);
        if (std::hypot(p.x - contact.x, p.z - contact.z) < 1e-9)
          gap = std::min(gap, std::fabs(p.y - contact.y));
      }
      EXPECT_LT(gap, 1e-3) << i;
    }
    EXPECT_GT(least_weight(stone.rest.contacts, pose.centre), -1e-6) << i;
    const Vec3d area = stone.rest.contact_area();
    if (area.length() > 0.01 * radius * radius) {
      EXPECT_GT(area.y / area.length(), maths::cos(36.001 * kPi / 180)) << i;
    }
  }
  EXPECT_LT(deep, bed.stones().size() / 20);
}

TEST_F(Bed, IsTheSameEachTime) {
  const Mesh ground = ground_mesh(2, 40, rough);
  const StoneBed a = laid(ground, 10, 60), b = laid(ground, 10, 60);
  ASSERT_EQ(a.stones().size(), b.stones().size());
  for (size_t i = 0; i < a.stones().size(); ++i) {
    EXPECT_EQ(a.stones()[i].rest.pose.centre, b.stones()[i].rest.pose.centre);
    EXPECT_EQ(a.stones()[i].rest.pose.x, b.stones()[i].rest.pose.x);
  }
}

TEST(StoneBed, RefusesSteepGroundAndLowRoofs) {
  const StoneShape round = stone_shape(cobble({0.1, 0.08, 0.09}));
  const Mesh steep = ground_mesh(1, 10, [](double x, double) { return 1.2 * x; });
  StoneBed on_steep(steep, {round}, {});
  EXPECT_FALSE(on_steep.add(0, 0.18, {0, 0, 0}, RandomKey(1)));
  // A slot of 10 cm between a floor and a roof.
  Mesh slot = ground_mesh(1, 4, [](double, double) { return 0.0; });
  Mesh roof = ground_mesh(1, 4, [](double, double) { return 0.1; });
  for (Triangle& t : roof.triangles) std::swap(t[1], t[2]);
  slot = joined(slot, roof);
  StoneBed in_slot(slot, {round}, {});
  EXPECT_FALSE(in_slot.add(0, 0.18, {0, 0, 0}, RandomKey(1)));
  EXPECT_TRUE(in_slot.add(0, 0.08, {0, 0, 0}, RandomKey(1)));
}

}  // namespace
}  // namespace vug::mesh
