// SPDX-License-Identifier: Apache-2.0
// Openness with known closed forms.
#include <vug/base/parallel.h>
#include <vug/mesh/shapes.h>
#include <vug/render/geometry/occlusion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace vug::render {
namespace {

mesh::MeshPtr quad(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
  mesh::Mesh mesh;
  mesh.positions = {a, b, c, d};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return std::make_shared<const mesh::Mesh>(std::move(mesh));
}

const mesh::MeshPtr kFloor = quad({-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9});

/// Averages points with equal surroundings, so that only the method's error remains.
double mean(const Openness& around, const std::vector<Vec3f>& places, const Vec3f& normal,
            const OpennessOptions& options) {
  const std::vector<float> got =
      around.compute(places, std::vector<Vec3f>(places.size(), normal), options);
  return std::accumulate(got.begin(), got.end(), 0.0) / static_cast<double>(got.size());
}

std::vector<Vec3f> along_z(const Vec3f& middle) {
  std::vector<Vec3f> places;
  for (int i = 0; i < 200; ++i)
    places.push_back(middle + Vec3f(0, 0, 0.001f * static_cast<float>(i)));
  return places;
}

OpennessOptions sky() {
  OpennessOptions options;
  options.sky = true;
  return options;
}

TEST(Openness, IsOneOnAPlaneHalfOnAWallZeroOnACeiling) {
  const Openness around({kFloor});
  EXPECT_EQ(mean(around, along_z(Vec3f(0)), {0, 1, 0}, {}), 1);
  EXPECT_EQ(mean(around, along_z(Vec3f(0)), {0, 1, 0}, sky()), 1);
  EXPECT_NEAR(mean(around, along_z({0, 1, 0}), {1, 0, 0}, sky()), 0.5, 0.005);
  EXPECT_EQ(mean(around, along_z({0, 1, 0}), {0, -1, 0}, sky()), 0);
}

TEST(Openness, NextToAWallFollowsTheAngleToItsTop) {
  // For a long wall whose top is at the angle b above the horizon, (1 - cos b) / 2 is occluded.
  const Openness around({kFloor, quad({0, 0, -500}, {0, 0, 500}, {0, 2, 500}, {0, 2, -500})});
  for (const double d : {0.5, 1.0, 2.0, 4.0}) {
    const double b = std::atan2(2, d);
    for (const OpennessOptions& options : {OpennessOptions{}, sky()})
      EXPECT_NEAR(mean(around, along_z({static_cast<float>(d), 0, 0}), {0, 1, 0}, options),
                  (1 + std::cos(b)) / 2, 0.005)
          << d;
  }
}

TEST(Openness, IgnoresOccludersBeyondTheMaximumDistance) {
  // Next to a wall, half of the directions hit it; within r of a point at the distance d, those
  // with sin * cos(turn) > d / r. Integrated over the projected disk, this is a circular segment.
  const Openness around({kFloor, quad({0, 0, -500}, {0, 0, 500}, {0, 500, 500}, {0, 500, -500})});
  OpennessOptions options;
  options.max_distance = 1;
  for (const double d : {0.1, 0.5, 0.8}) {
    const double closed = (std::acos(d) - d * std::sqrt(1 - d * d)) / kPi;
    EXPECT_NEAR(mean(around, along_z({static_cast<float>(d), 0, 0}), {0, 1, 0}, options),
                1 - closed, 0.005)
        << d;
  }
  EXPECT_EQ(mean(around, along_z({1.01f, 0, 0}), {0, 1, 0}, options), 1);
}

TEST(Openness, IsZeroInsideABoxForAnyNumberOfThreads) {
  const auto box =
      std::make_shared<const mesh::Mesh>(mesh::box_mesh(Box3d(Vec3d(-1), Vec3d(1, 2, 3))));
  const Openness around({box, kFloor});
  std::vector<Vec3f> places = along_z({0.5f, -1, 0}), normals(places.size(), Vec3f(0, 1, 0));
  for (const float share : around.compute(places, normals, {})) EXPECT_EQ(share, 0);
  places.insert(places.end(), 3000, Vec3f(3, 0.5f, 2));
  normals.resize(places.size(), Vec3f(0, 1, 0));
  std::vector<float> expected;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const std::vector<float> got = around.compute(places, normals, {});
      if (threads == 1) expected = got;
      EXPECT_EQ(got, expected);
    });
  }
}

}  // namespace
}  // namespace vug::render
