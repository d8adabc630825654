// SPDX-License-Identifier: Apache-2.0
// Automatic portals are found where the sky is visible, and change only the noise.
#include "runs.h"

#include <gtest/gtest.h>
#include <vug/render/paths/automatic_portals.h>
#include <vug/render/paths/boundary_hits.h>
#include <vug/render/prepared_scene.h>

namespace vug::render {
namespace {

void add_quad(mesh::Mesh& mesh, const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A room of 4 x 3 x 4 m whose roof has a hole of 0.5 x 0.5 m around (hole, hole).
Scene room_with_hole(float hole) {
  mesh::Mesh m;
  const float s = 2, h = 3, a = hole - 0.25f, b = hole + 0.25f;
  add_quad(m, {-s, 0, -s}, {-s, 0, s}, {s, 0, s}, {s, 0, -s});
  add_quad(m, {-s, 0, -s}, {s, 0, -s}, {s, h, -s}, {-s, h, -s});
  add_quad(m, {-s, 0, s}, {-s, h, s}, {s, h, s}, {s, 0, s});
  add_quad(m, {-s, 0, -s}, {-s, h, -s}, {-s, h, s}, {-s, 0, s});
  add_quad(m, {s, 0, -s}, {s, 0, s}, {s, h, s}, {s, h, -s});
  add_quad(m, {-s, h, -s}, {s, h, -s}, {s, h, a}, {-s, h, a});
  add_quad(m, {-s, h, b}, {s, h, b}, {s, h, s}, {-s, h, s});
  add_quad(m, {-s, h, a}, {a, h, a}, {a, h, b}, {-s, h, b});
  add_quad(m, {b, h, a}, {s, h, a}, {s, h, b}, {b, h, b});
  Scene scene;
  scene.objects.push_back(object(std::move(m), 0.5));
  scene.lights.push_back(make_light("sky", {{"radiance", Vec3d(10)}}));
  scene.camera = view({-1.5, 1.5, 1.5}, {0.5, 0.5, -0.5}, 1.2);
  return scene;
}

TEST(AutomaticPortals, AreFoundWhereTheRoofIsOpen) {
  const Scene scene = room_with_hole(0.7f);
  const PreparedScene world(scene);
  const SamplerPtr sampler = make_sampler("sobol");
  const auto portals =
      find_automatic_portals({world, *scene.camera, *sampler, 1, 1000, 3}, Progress::none());
  ASSERT_EQ(portals.size(), 1u);
  EXPECT_NEAR(portals[0].center.x, 0.7, 0.1);
  EXPECT_NEAR(portals[0].center.y, 3, 1e-5);
  EXPECT_NEAR(portals[0].center.z, 0.7, 0.1);
}

TEST(AutomaticPortals, AreNotSearchedInOpenScenes) {
  Scene scene;
  scene.objects.push_back(object(floor_mesh(3), 0.5));
  scene.lights.push_back(make_light("sky"));
  scene.camera = view({0, 2, 3}, {0, 0, 0}, 1);
  const PreparedScene world(scene);
  const SamplerPtr sampler = make_sampler("sobol");
  EXPECT_TRUE(find_automatic_portals({world, *scene.camera, *sampler, 1, 1000, 3}, Progress::none())
                  .empty());
}

TEST(AutomaticPortals, KeepTheMean) {
  constexpr int kRuns = 16;
  const Scene scene = room_with_hole(-0.4f);
  double mean[2] = {0, 0}, square[2] = {0, 0}, spread[2];
  for (int found = 0; found < 2; ++found) {
    for (int run = 0; run < kRuns; ++run) {
      Options o = options(12, 9, found ? 16 : 256, 4);
      o.openings = found;
      o.seed = static_cast<uint64_t>(run);
      const double m = mean_of(render(scene, o), "G").value;
      mean[found] += m / kRuns;
      square[found] += m * m / kRuns;
    }
    spread[found] = (square[found] - mean[found] * mean[found]) / (kRuns - 1);
  }
  EXPECT_LT(std::fabs(mean[1] - mean[0]), 4 * std::sqrt(spread[0] + spread[1]));
  // A sixteenth of the samples gives still less noise.
  EXPECT_LT(spread[1], spread[0]);
  EXPECT_LT(std::sqrt(spread[0]), 0.02 * mean[0]);
}

/// The room under a clear sky, which samples directions; most of them hit the roof.
Scene room_under_daylight() {
  Scene scene = room_with_hole(-0.4f);
  scene.lights = {make_light("daylight", {{"elevation", radians(1.2)}})};
  return scene;
}

TEST(AutomaticPortals, KeepTheMeanOfDaylightWithLessNoise) {
  constexpr int kRuns = 12;
  const Scene scene = room_under_daylight();
  Runs runs[2];
  for (int found = 0; found < 2; ++found)
    for (int run = 0; run < kRuns; ++run) {
      Options o = options(12, 9, 64, 4);
      o.aovs = plan_aovs({"beauty", "variance"}, {});
      o.openings = found;
      o.seed = static_cast<uint64_t>(run);
      runs[found].add(render(scene, o));
    }
  const double error = error_of_difference(runs[0], runs[1]);
  EXPECT_LT(std::fabs(runs[1].mean() - runs[0].mean()), 3 * error);
  EXPECT_LT(error, 0.05 * runs[0].mean());
  EXPECT_LT(runs[1].variance(), 0.5 * runs[0].variance());
}

TEST(AutomaticPortals, LeaveTheShadowRaysToASunBesideDaylight) {
  Scene scene = room_under_daylight();
  scene.lights.push_back(make_light("sun", {{"elevation", radians(1.2)}}));
  const PreparedScene world(scene);
  const SamplerPtr sampler = make_sampler("sobol");
  EXPECT_TRUE(find_automatic_portals({world, *scene.camera, *sampler, 1, 1000, 3}, Progress::none())
                  .empty());
}

TEST(AutomaticPortals, AreTheSameForAnyNumberOfThreads) {
  const auto picture = [](const char* sky, int threads) {
    Options o = options(8, 6, 8, 4);
    o.threads = threads;
    return render(*sky ? room_under_daylight() : room_with_hole(0.2f), o);
  };
  for (const char* sky : {"", "daylight"}) {
    const image::Image one = picture(sky, 1);
    EXPECT_EQ(one, picture(sky, 2)) << sky;
    EXPECT_EQ(one, picture(sky, 7)) << sky;
  }
}

TEST(AutomaticPortals, RectanglesEncloseBoundaryHits) {
  BoundaryHits exits(Box3f(Vec3f(0.0f), Vec3f(64.0f)));
  exits.count({{10.5f, 60, 20.5f}, {0, 1, 0}});
  exits.count({{12.5f, 60, 20.5f}, {0, 1, 0}});
  exits.count({{40.5f, 60, 20.5f}, {0, 1, 0}});
  const auto found = exits.rectangles(8, 0);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].center, Vec3d(11.5, 64, 20.5));
  EXPECT_EQ(found[0].normal, Vec3d(0, -1, 0));
  EXPECT_EQ(std::max(found[0].width, found[0].height), 3);
  EXPECT_EQ(std::min(found[0].width, found[0].height), 1);
  EXPECT_EQ(exits.rectangles(1, 1).size(), 1u);
}

}  // namespace
}  // namespace vug::render
