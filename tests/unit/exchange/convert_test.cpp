// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/format.h>

#include <gtest/gtest.h>

#include "sample.h"

namespace vug::exchange {
namespace {

constexpr Space kSpaces[] = {{UpAxis::y, 1}, {UpAxis::z, 1}, {UpAxis::y, 0.01}, {UpAxis::z, 0.01}};

/// A direction of our space in another.
Vec3d up_in(const Space& space) { return space.up == UpAxis::y ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1); }

TEST(Convert, AMetreStaysAMetreAndUpStaysUp) {
  for (const Space& space : kSpaces) {
    const Assembly all = converted(sample(), space);
    const Assembly one = [&] {
      Assembly only = all;
      only.groups.resize(1);
      return only;
    }();
    const Vec3d size = bounds(one).size() * space.metres_per_unit;
    EXPECT_LT((size - Vec3d(1.0)).length(), 1e-6);
    // The camera of the plan looks down, the lights shine down.
    EXPECT_LT((all.cameras[1].place.vector({0, 0, -1}) + up_in(space)).length(), 1e-14);
    for (const Light& light : all.lights)
      EXPECT_LT((light.place.vector({0, 0, -1}) + up_in(space)).length(), 1e-14) << light.name;
    EXPECT_NEAR(all.cameras[0].place.origin().dot(up_in(space)) * space.metres_per_unit, 1.5,
                1e-12);
    EXPECT_NEAR(all.cameras[0].focus * space.metres_per_unit, 3, 1e-12);
    EXPECT_EQ(all.cameras[0].fov, 0.5 * kPi);
  }
}

TEST(Convert, LightsKeepTheirRadianceAndPower) {
  const Assembly before = sample();
  for (const Space& space : kSpaces) {
    const Assembly all = converted(before, space);
    for (size_t i = 0; i < all.lights.size(); ++i) {
      EXPECT_EQ(all.lights[i].radiance, before.lights[i].radiance);
      const double square = space.metres_per_unit * space.metres_per_unit;
      EXPECT_LT((power(all.lights[i]) * square - power(before.lights[i])).length(), 1e-12);
    }
  }
}

TEST(Convert, ColoursAreUnchangedAndVectorsRotate) {
  const Assembly before = sample();
  const Assembly all = converted(before, {UpAxis::z, 0.01});
  const mesh::Mesh &here = *before.prototypes[0].mesh, &there = *all.prototypes[0].mesh;
  EXPECT_EQ(here.attributes[0], there.attributes[0]);
  EXPECT_EQ(here.attributes[1], there.attributes[1]);
  for (size_t v = 0; v < there.positions.size(); ++v)
    EXPECT_EQ(there.attributes[2].values[3 * v + 2], 1);
  for (size_t v = 0; v < there.positions.size(); ++v)
    EXPECT_EQ(there.normals[v], Vec3f(here.normals[v].x, -here.normals[v].z, here.normals[v].y));
}

TEST(Convert, RoundTripIsTheIdentity) {
  const Assembly before = sample();
  const Assembly again = converted(converted(before, {UpAxis::z, 0.01}), before.space);
  for (size_t g = 0; g < before.groups.size(); ++g)
    for (size_t i = 0; i < before.groups[g].places.size(); ++i) {
      const Transform &a = before.groups[g].places[i], &b = again.groups[g].places[i];
      for (int c = 0; c < 3; ++c) EXPECT_LT((a.column(c) - b.column(c)).length(), 1e-14);
      EXPECT_LT((a.origin() - b.origin()).length(), 1e-13);
    }
  EXPECT_LT((bounds(before).max - bounds(again).max).length(), 1e-6);
}

TEST(Convert, InstancesKeepTheirPlace) {
  const Box3d before = bounds(sample());
  for (const Space& space : kSpaces) {
    const Box3d here = space_transform({}, space).inverse().box(bounds(converted(sample(), space)));
    EXPECT_LT((here.min - before.min).length() + (here.max - before.max).length(), 1e-5);
  }
}

TEST(Lights, PowerIsRadianceOverAreaAndDirections) {
  const Assembly all = sample();
  // The closed forms for each shape, for a radiance of 1.
  const double expected[] = {4 * kPi * kPi / 16, kPi / 8, kPi * kPi / 16};
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(power(all.lights[i]).z, expected[i], 1e-12);
  EXPECT_NEAR(peak_intensity(all.lights[4]).z, kPi * 0.005 * 0.005, 1e-9);
}

}  // namespace
}  // namespace vug::exchange
