// SPDX-License-Identifier: Apache-2.0
// Solids that touch are one solid, without a crack between them.
#include "solids.h"

#include <vug/mesh/self_intersections.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <utility>

namespace vug::meshing {
namespace {

field::Field moved(const field::Field& f, const Vec3d& by) {
  return field::transformed(f, Transform::translation(by));
}

/// Two solids that share a face.
struct Contact {
  const char* name;
  field::Field solid;
  double area;
};

std::vector<Contact> contacts() {
  const field::Field box = solid(Box{Vec3d(0.5)}), slab = solid(Box{{1, 0.1, 0.6}});
  const field::Field rod = solid(Rod{0.4, 0.5});
  // An upright prism: half of a box that is cut diagonally.
  const field::Field half = field::intersect(
      {box, turned(solid(Box{Vec3d(1)}), {0, 1, 0}, kPi / 4, {std::sqrt(0.5), 0, std::sqrt(0.5)})});
  const field::Field other = field::transformed(half, Transform::rotation({0, 1, 0}, kPi));
  // The flat ends of two half capsules.
  const field::Field capsule = solid(Capsule{0.4, 0.6});
  const field::Field upper = field::intersect({capsule, moved(solid(Box{Vec3d(2)}), {0, 2, 0})});
  const field::Field lower = field::intersect({capsule, moved(solid(Box{Vec3d(2)}), {0, -2, 0})});
  return {
      {"boxes", field::unite({moved(box, {-0.5, 0, 0}), moved(box, {0.5, 0, 0})}), 10},
      {"slabs", field::unite({moved(slab, {0, -0.1, 0}), moved(slab, {0, 0.1, 0})}),
       2 * (2 * 1.2 + 2 * 0.4 + 1.2 * 0.4)},
      {"rods", field::unite({moved(rod, {0, -0.5, 0}), moved(rod, {0, 0.5, 0})}),
       2 * kPi * 0.4 * (2 + 0.4)},
      {"prisms", field::unite({half, other}), 6},
      {"capsules", field::unite({upper, lower}), kPi * (4 * 0.16 + 2 * 0.4 * 1.2)},
  };
}

void expect_one_solid(const field::Field& field, double expected_area) {
  const mesh::Mesh mesh = polygonized(field, 0.05).mesh;
  const mesh::Topology topology = mesh::inspect(mesh);
  EXPECT_EQ(topology.components, 1U);
  EXPECT_EQ(topology.genus, 0U);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.degenerate_triangles, 0U);
  EXPECT_EQ(mesh::self_intersections(mesh).size(), 0U);
  EXPECT_NEAR(area(mesh) / expected_area, 1, 1e-2);
}

TEST(Contact, InAFaceJoinsSolids) {
  for (const Contact& contact : contacts()) {
    SCOPED_TRACE(contact.name);
    for (const Vec3d& by : {Vec3d(0), Vec3d(0.05, 0.1, -0.15), Vec3d(20, -15, 40),
                            Vec3d(0.0131, -0.0227, 0.0179), Vec3d(0.025)}) {
      SCOPED_TRACE(testing::Message() << by.x << " " << by.y << " " << by.z);
      expect_one_solid(moved(contact.solid, by), contact.area);
    }
    for (const auto& [axis, angle] : {std::pair(Vec3d(0, 1, 0), kPi / 4),
                                      {Vec3d(1, 0, 0), kPi / 2},
                                      {Vec3d(0, 0, 1), 0.3},
                                      {Vec3d(1, 2, 3), 0.7}}) {
      SCOPED_TRACE(testing::Message() << "turned by " << angle);
      expect_one_solid(turned(contact.solid, axis, angle), contact.area);
    }
  }
}

}  // namespace
}  // namespace vug::meshing
