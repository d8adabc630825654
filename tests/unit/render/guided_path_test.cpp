// SPDX-License-Identifier: Apache-2.0
// Guiding makes paths find light sooner, but does not change the expected result.
#include "scenes.h"

#include <vug/render/film/light_path_recorder.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

/// A hollow sphere with a sill in front of its light: most of it is lit only indirectly.
Scene hidden_light() {
  Scene scene;
  scene.objects.push_back(object(mesh::sphere_mesh(Vec3d(0), 1, 4), 0.6));
  mesh::Mesh sill = floor_mesh(0.5f);
  for (Vec3f& p : sill.positions) p.y += 0.45f;
  scene.objects.push_back(object(std::move(sill), 0.6));
  scene.lights.push_back(make_light(
      "sphere", {{"center", Vec3d(0, 0.6, 0)}, {"radius", 0.05}, {"radiance", Vec3d(60, 50, 40)}}));
  scene.camera = view({0, -0.2, 0.8}, {0, -0.3, 0}, 1.2);
  return scene;
}

image::Image picture(const char* guide, uint64_t seed, int spp, int threads = 0,
                     const char* roulette = "worth", int light_samples = 2) {
  Options o = options(16, 12, spp, 6);
  o.aovs = plan_aovs({"beauty", "parts"}, {});
  o.integrator = make_integrator("path", {{"max_bounces", 6},
                                          {"guide", Value::Name{guide}},
                                          {"roulette", Value::Name{roulette}},
                                          {"light_samples", light_samples}});
  o.seed = seed;
  o.threads = threads;
  return render(hidden_light(), o);
}

TEST(GuidedPath, HasTheSameMean) {
  constexpr int kRuns = 12;
  enum { plain, led, led_to_the_end, led_by_throughput, plain_of_one_light, count };
  const auto taken_by = [](int way, uint64_t seed) {
    switch (way) {
      case plain:
        return picture("off", seed, 256);
      case led:
        return picture("on", seed, 256);
      case led_to_the_end:
        return picture("on", seed, 256, 0, "off");
      case led_by_throughput:
        return picture("on", seed, 256, 0, "throughput", 4);
      default:
        return picture("off", seed, 256, 0, "throughput", 1);
    }
  };
  double mean[count] = {}, square[count] = {};
  for (int run = 0; run < kRuns; ++run)
    for (int way = 0; way < count; ++way) {
      const double m = mean_of(taken_by(way, static_cast<uint64_t>(run + 1)), "R").value;
      mean[way] += m / kRuns;
      square[way] += m * m / kRuns;
    }
  double variance[count] = {};
  for (int way = 0; way < count; ++way)
    variance[way] = (square[way] - mean[way] * mean[way]) / (kRuns - 1);
  EXPECT_GT(mean[plain], 0);
  for (const int way : {plain, led_to_the_end, led_by_throughput, plain_of_one_light}) {
    const double error = std::sqrt(variance[led] + variance[way]);
    EXPECT_LT(std::fabs(mean[led] - mean[way]), 4 * error) << way;
    EXPECT_LT(error, 0.01 * mean[way]);
  }
}

/// Light that paths find by chance counts the same in the whole and in its parts.
TEST(GuidedPath, PartsSumToTheBeauty) {
  const image::Image taken = picture("on", 3, 64);
  double whole = 0, sum = 0;
  for (const char* c : {"R", "G", "B"}) {
    whole += mean_of(taken, c).value;
    for (const auto& [part, doc] : light_components()) sum += mean_of(taken, part + "." + c).value;
  }
  EXPECT_GT(mean_of(taken, "diffuse_indirect.R").value, 0);
  EXPECT_NEAR(sum, whole, 1e-5 * whole);
}

/// A hall under a narrow shaft in its ceiling that a light illuminates: all light on the floor has
/// been reflected by the shaft's walls.
Scene hall_under_a_shaft() {
  Scene scene;
  mesh::Mesh walls;
  const auto quad = [&](Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
    const auto first = static_cast<uint32_t>(walls.positions.size());
    for (const Vec3f& p : {a, b, c, d}) walls.positions.push_back(p);
    walls.triangles.push_back({first, first + 1, first + 2});
    walls.triangles.push_back({first, first + 2, first + 3});
  };
  // A tube of four walls with square ends, open where another tube continues.
  const auto tube = [&](float half, float low, float high) {
    const Vec3f corner[4] = {
        {-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
    const Vec3f up(0, high, 0), down(0, low, 0);
    for (int i = 0; i < 4; ++i) {
      const Vec3f a = corner[i], b = corner[(i + 1) % 4];
      quad(a + down, b + down, b + up, a + up);
    }
  };
  constexpr float kHall = 2, kShaft = 0.4f, kCeiling = 2, kTop = 3.5f;
  tube(kHall, 0, kCeiling), tube(kShaft, kCeiling, kTop);
  const auto level = [&](float x0, float x1, float y, float z0, float z1) {
    quad({x0, y, z0}, {x0, y, z1}, {x1, y, z1}, {x1, y, z0});
  };
  level(-kHall, kHall, 0, -kHall, kHall);
  level(-kHall, kHall, kCeiling, kShaft, kHall), level(-kHall, kHall, kCeiling, -kHall, -kShaft);
  level(kShaft, kHall, kCeiling, -kShaft, kShaft),
      level(-kHall, -kShaft, kCeiling, -kShaft, kShaft);
  level(-kShaft, kShaft, kTop, -kShaft, kShaft);
  scene.objects.push_back(object(std::move(walls), 0.6));
  scene.lights.push_back(make_light("rect", {{"center", Vec3d(0.39, 3, 0)},
                                             {"normal", Vec3d(-1, 0, 0)},
                                             {"up", Vec3d(0, 1, 0)},
                                             {"width", 0.2},
                                             {"height", 0.2},
                                             {"radiance", Vec3d(100, 100, 100)}}));
  scene.camera = view({1.8, 1, 1.8}, {-1, 0.5, -1}, 1.2);
  return scene;
}

TEST(GuidedPath, FindsLightThroughAShaft) {
  constexpr int kRuns = 4;
  double mean[2] = {0, 0}, variance[2] = {0, 0};
  for (int led = 0; led < 2; ++led) {
    const auto taken = [&](uint64_t seed) {
      Options o = options(24, 16, 64, 6);
      o.integrator =
          make_integrator("path", {{"max_bounces", 6}, {"guide", Value::Name{led ? "on" : "off"}}});
      o.seed = seed;
      return render(hall_under_a_shaft(), o);
    };
    for (uint64_t run = 0; run < kRuns; ++run) {
      const image::Image one = taken(2 * run + 1), two = taken(2 * run + 2);
      for (size_t i = 0; i < one.pixels.size(); i += one.channels.size()) {
        const auto a = static_cast<double>(one.pixels[i]), b = static_cast<double>(two.pixels[i]);
        variance[led] += (a - b) * (a - b) / 2;
        mean[led] += (a + b) / 2;
      }
    }
    const double count = kRuns * 24 * 16;
    mean[led] /= count, variance[led] /= count;
  }
  EXPECT_LT(variance[1], 0.6 * variance[0]);
  EXPECT_LT(std::fabs(mean[1] - mean[0]),
            4 * std::sqrt((variance[0] + variance[1]) / (2 * kRuns * 24 * 16)));
}

/// The hollow sphere with walls in which light scatters: all of them, or where a mask says so.
Scene scattering_walls(bool mixed) {
  Scene scene = hidden_light();
  mesh::Mesh walls = mesh::sphere_mesh(Vec3d(0), 1, 4);
  for (auto& triangle : walls.triangles) std::swap(triangle[1], triangle[2]);
  const auto inner = static_cast<uint32_t>(walls.positions.size());
  const mesh::Mesh outer = mesh::sphere_mesh(Vec3d(0), 1.2, 3);
  walls.positions.insert(walls.positions.end(), outer.positions.begin(), outer.positions.end());
  for (const auto& t : outer.triangles)
    walls.triangles.push_back({t[0] + inner, t[1] + inner, t[2] + inner});
  scene.objects[0] = object(std::move(walls), 0.6);
  const MaterialPtr cloudy =
      make_material("surface", {{"color", Vec3d(0.7)},
                                {"subsurface", 0.6},
                                {"mean_free_path", Number{0.01, Dimension::length}}});
  const MaterialPtr metal = make_material("surface", {{"metal", 1.0}, {"roughness", 0.4}});
  scene.objects[0].material =
      mixed ? make_material("mix", {{"a", ValueTraits<MaterialPtr>::write(cloudy)},
                                    {"b", ValueTraits<MaterialPtr>::write(metal)},
                                    {"mask", 0.3}})
            : cloudy;
  return scene;
}

/// Guiding replaces only the samples that stay above such a surface.
TEST(GuidedPath, KeepsTheMeanOfWallsInWhichLightScattersWithLessNoise) {
  for (const bool mixed : {false, true}) {
    const Scene scene = scattering_walls(mixed);
    constexpr int kRuns = 8;
    double mean[2] = {}, square[2] = {}, noise[2] = {};
    for (int run = 0; run < 2 * kRuns; ++run) {
      const int led = run % 2;
      Options o = options(16, 12, 64, 6);
      o.integrator =
          make_integrator("path", {{"max_bounces", 6}, {"guide", Value::Name{led ? "on" : "off"}}});
      o.aovs = plan_aovs({"beauty", "variance"}, {});
      o.seed = static_cast<uint64_t>(run / 2 + 1);
      const image::Image taken = render(scene, o);
      const double m = mean_of(taken, "G").value;
      mean[led] += m / kRuns;
      square[led] += m * m / kRuns;
      noise[led] += mean_of(taken, "variance.G").value / kRuns;
    }
    double error = 0;
    for (const int led : {0, 1}) error += (square[led] - mean[led] * mean[led]) / (kRuns - 1);
    error = std::sqrt(error);
    EXPECT_GT(mean[0], 0);
    EXPECT_LT(std::fabs(mean[1] - mean[0]), 3 * error) << mixed;
    EXPECT_LT(error, 0.02 * mean[0]) << mixed;
    EXPECT_LT(noise[1], 0.95 * noise[0]) << mixed;
  }
}

TEST(GuidedPath, HasTheSameBytesForAnyNumberOfThreads) {
  const image::Image one = picture("on", 5, 16, 1);
  EXPECT_EQ(one, picture("on", 5, 16, 2));
  EXPECT_EQ(one, picture("on", 5, 16, 7));
  Options o = options(16, 12, 8, 6);
  o.integrator = make_integrator("path", {{"max_bounces", 6}, {"guide", Value::Name{"on"}}});
  const auto with_threads_of = [&](int threads) {
    o.threads = threads;
    return render(scattering_walls(true), o);
  };
  const image::Image mixed = with_threads_of(1);
  EXPECT_EQ(mixed, with_threads_of(2));
  EXPECT_EQ(mixed, with_threads_of(7));
}

}  // namespace
}  // namespace vug::render
