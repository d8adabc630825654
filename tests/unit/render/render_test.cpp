// SPDX-License-Identifier: Apache-2.0
// Properties of whole pictures: determinism, AOVs, convergence, errors.
#include "scenes.h"

#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/image/measure.h>

#include <gtest/gtest.h>

#include <limits>

namespace vug::render {
namespace {

/// A light, a ball and haze in a box with a hole to the sky.
Scene room(bool portal = false) {
  Scene scene;
  scene.camera = view({0, -0.2, 1.8}, {0, -0.3, 0}, 1.2);
  mesh::Mesh box = mesh::box_mesh({Vec3d(-2), Vec3d(2)});
  // Replaces the lid by one with a square hole of one metre.
  std::vector<mesh::Triangle> kept;
  for (const mesh::Triangle& t : box.triangles)
    if (box.positions[t[0]].y < 1 || box.positions[t[1]].y < 1 || box.positions[t[2]].y < 1)
      kept.push_back(t);
  box.triangles = kept;
  const auto base = static_cast<uint32_t>(box.positions.size());
  for (const float half : {2.0f, 0.5f})
    for (const Vec2f& corner : {Vec2f(-1, -1), Vec2f(1, -1), Vec2f(1, 1), Vec2f(-1, 1)})
      box.positions.emplace_back(corner.x * half, 2.0f, corner.y * half);
  for (uint32_t i = 0; i < 4; ++i) {
    const uint32_t j = (i + 1) % 4;
    box.triangles.push_back({base + i, base + j, base + 4 + j});
    box.triangles.push_back({base + i, base + 4 + j, base + 4 + i});
  }
  scene.objects = {object(box, 0.5),
                   object(with_radial_normals(mesh::sphere_mesh({0, 0, 0}, 0.6, 3), 1), 0.7)};
  scene.lights = {make_light("sky", {{"radiance", Vec3d(3, 4, 5)}}),
                  make_light("rect", {{"center", Vec3d(1.9, 0, 0)},
                                      {"normal", Vec3d(-1, 0, 0)},
                                      {"width", 0.4},
                                      {"height", 0.4},
                                      {"radiance", Vec3d(9, 6, 3)}})};
  if (portal)
    scene.lights.push_back(make_light("portal", {{"center", Vec3d(0, 2, 0)},
                                                 {"normal", Vec3d(0, -1, 0)},
                                                 {"width", 1.0},
                                                 {"height", 1.0}}));
  return scene;
}

Digest bytes(const image::Image& picture) {
  return digest(picture.pixels.data(), picture.pixels.size() * sizeof(float));
}

TEST(Render, SameBytesForAnyThreadsAndTiles) {
  Scene scene = room(true);
  scene.medium = make_medium("haze", {{"extinction", 0.05}});
  Options o = options(61, 37, 4, 4);
  o.threads = 1;
  const Digest one = bytes(render(scene, o));
  for (const int threads : {2, 5, 8})
    for (const int tile : {8, 16, 37}) {
      o.threads = threads, o.tile_size = tile;
      EXPECT_EQ(bytes(render(scene, o)), one) << threads << " threads, tiles of " << tile;
    }
  o.seed = 1;
  EXPECT_NE(bytes(render(scene, o)), one);
}

TEST(Render, PortalsKeepTheMeanAndReduceTheNoise) {
  Options o = options(48, 32, 128, 3);
  o.openings = false;
  const image::Image with = render(room(true), o), without = render(room(false), o);
  Options other = o;
  other.seed = 5;
  const image::Image again = render(room(true), other), and_again = render(room(false), other);
  // Pairs of renders with different seeds estimate the noise of the mean.
  for (const char* channel : {"R", "G", "B"}) {
    const auto c = static_cast<size_t>(with.find_channel(channel));
    double difference = 0, variance = 0, calm = 0, loud = 0;
    for (size_t i = c; i < with.pixels.size(); i += with.channels.size()) {
      const auto w = static_cast<double>(with.pixels[i]), w2 = static_cast<double>(again.pixels[i]);
      const auto n = static_cast<double>(without.pixels[i]),
                 n2 = static_cast<double>(and_again.pixels[i]);
      difference += 0.5 * (w + w2 - n - n2);
      variance += 0.25 * ((w - w2) * (w - w2) + (n - n2) * (n - n2));
      calm += (w - w2) * (w - w2), loud += (n - n2) * (n - n2);
    }
    EXPECT_LT(std::fabs(difference), 4 * std::sqrt(variance)) << channel;
    EXPECT_LT(calm, 0.5 * loud) << channel;
  }
}

TEST(Render, HazeAndPortalsAgree) {
  Scene with = room(true), without = room(false);
  with.medium = without.medium = make_medium("haze", {{"extinction", 0.3}, {"g", 0.3}});
  const Options o = options(24, 16, 512, 3);
  const image::Image a = render(with, o), b = render(without, o);
  double sum = 0, squares = 0;
  for (size_t i = 1; i < a.pixels.size(); i += a.channels.size()) {
    const auto d = static_cast<double>(a.pixels[i] - b.pixels[i]);
    sum += d, squares += d * d;
  }
  EXPECT_LT(std::fabs(sum), 4 * std::sqrt(squares));
  EXPECT_LT(std::sqrt(squares / static_cast<double>(a.pixel_count())), 0.2);
}

// The floor hides a light of a thousand times the power: it must not take samples from the visible
// light, whether lights are selected or all sampled.
TEST(Render, AnOccludedLightDoesNotAffectOthers) {
  const auto lit = [](size_t hidden) {
    Scene scene = room();
    scene.lights.erase(scene.lights.begin());  // the sky
    for (size_t i = 0; i < hidden; ++i)
      scene.lights.push_back(make_light("sphere", {{"center", Vec3d(1.5, -3, 0.1 * double(i))},
                                                   {"radius", 0.2},
                                                   {"radiance", Vec3d(5000.0)}}));
    return scene;
  };
  const Options o = options(24, 16, 256, 0);
  const image::Image alone = render(lit(0), o);
  for (const size_t hidden : {size_t{1}, size_t{12}}) {
    const image::Image seen = render(lit(hidden), o);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < seen.pixels.size(); i += seen.channels.size()) {
      const auto d = static_cast<double>(seen.pixels[i] - alone.pixels[i]);
      sum += d, squares += d * d;
    }
    EXPECT_LE(std::fabs(sum), 4 * std::sqrt(squares)) << hidden;
    EXPECT_LT(std::sqrt(squares / static_cast<double>(seen.pixel_count())), 0.06) << hidden;
  }
}

TEST(Render, ClampOnlyAffectsIndirectLight) {
  const Scene scene = room();
  const auto red = [&](int bounces, double clamp) {
    Options o = options(24, 16, 64, bounces);
    o.integrator = make_integrator("path", {{"max_bounces", double(bounces)}, {"clamp", clamp}});
    return mean_of(render(scene, o), "R").value;
  };
  EXPECT_EQ(red(0, 1e-3), red(0, 1e6)) << "direct light is not clamped";
  EXPECT_EQ(mean_of(render(scene, options(24, 16, 64, 3)), "R").value, red(3, 1e6));
  EXPECT_LT(red(3, 0.05), 0.98 * red(3, 1e6));
  EXPECT_GT(red(3, 0.05), red(0, 1e6));
}

// The squared error against the mean of many samples falls as 1/N for independent samples, and at
// least as fast for Sobol points.
TEST(Render, ErrorFallsWithSamples) {
  const Scene scene = room(true);
  Options o = options(32, 24, 1024, 3);
  o.seed = 99;
  const image::Image reference = render(scene, o).select({"R", "G", "B"});
  const auto slope = [&](const char* sampler, double& error_at_16) {
    const auto squared = [&](int spp) {
      Options few = options(32, 24, spp, 3);
      few.sampler = make_sampler(sampler);
      const double rmse =
          image::measure("rmse", reference, render(scene, few).select({"R", "G", "B"}));
      return rmse * rmse;
    };
    error_at_16 = squared(16);
    return std::log(squared(64) / error_at_16) / std::log(4.0);
  };
  double independent = 0, sobol = 0;
  const double slope_independent = slope("independent", independent);
  EXPECT_GT(slope_independent, -1.2);
  EXPECT_LT(slope_independent, -0.8);
  EXPECT_LT(slope("sobol", sobol), -0.9);
  EXPECT_LT(sobol, 0.9 * independent);
}

TEST(Render, AovsDescribeTheFirstHit) {
  Scene scene;
  scene.camera = view({0, 3, 0}, {0, 0, 0}, 1.0, {0, 0, -1});
  mesh::Mesh floor = floor_mesh(0.5f);
  floor.attributes.push_back({"Cd", 3, std::vector<float>(12, 0.5f)});
  scene.objects = {object(floor, 0.8)};
  const image::Image picture = render(scene, options(33, 33, 4, 0));
  const auto at = [&](int x, int y, const char* channel) {
    return picture.at(x, y, static_cast<size_t>(picture.find_channel(channel)));
  };
  EXPECT_EQ(at(16, 16, "A"), 1);
  EXPECT_NEAR(at(16, 16, "Z"), 3, 1e-5);
  EXPECT_NEAR(at(16, 16, "N.Y"), 1, 1e-6);
  EXPECT_NEAR(at(16, 16, "P.Y"), 0, 1e-6);
  EXPECT_NEAR(at(16, 16, "albedo.G"), 0.4, 1e-6);
  // The depth is constant on the plane; the distances are not.
  EXPECT_NEAR(at(12, 12, "Z"), 3, 1e-5);
  EXPECT_EQ(at(0, 0, "A"), 0);
  EXPECT_EQ(at(0, 0, "Z"), 1e10f);
  EXPECT_EQ(at(0, 0, "albedo.R"), 0);
}

TEST(Render, OnlyVisibleLightsAreSeen) {
  for (const bool visible : {true, false}) {
    Scene scene;
    scene.camera = view({0, 0, 3}, {0, 0, 0}, 0.1);
    scene.lights = {make_light("sphere", {{"radius", 1.0}, {"visible", visible}})};
    const image::Image picture = render(scene, options(4, 4, 4, 0));
    EXPECT_EQ(mean_of(picture, "R").value, visible ? 1 : 0);
    EXPECT_EQ(mean_of(picture, "A").value, visible ? 1 : 0);
  }
}

TEST(Render, RejectsInvalidInputAndCancels) {
  Scene scene = room();
  EXPECT_THROW(render(scene, options(0, 4, 4, 0)), Error);
  EXPECT_THROW(render(scene, options(4, 4, 0, 0)), Error);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(render(scene, options(4, 4, 4, 0), cancelled), Error);
  Scene blind = scene;
  blind.camera = nullptr;
  EXPECT_THROW(render(blind, options(4, 4, 4, 0)), Error);
  auto broken = std::make_shared<mesh::Mesh>(*scene.objects[0].mesh);
  broken->triangles[0][1] = 1000000;
  scene.objects[0].mesh = broken;
  EXPECT_THROW(render(scene, options(4, 4, 4, 0)), Error);
  auto nan = std::make_shared<mesh::Mesh>(*room().objects[0].mesh);
  nan->positions[0].x = std::numeric_limits<float>::quiet_NaN();
  scene.objects[0].mesh = nan;
  EXPECT_THROW(render(scene, options(4, 4, 4, 0)), Error);
}

// A tiny light in front of a mirror: light that reaches the floor by way of the mirror is found
// only by chance, and equals the light of the mirror image. With regularization it is always found,
// a little blurred.
TEST(Render, RegularizingBlursCaustics) {
  const auto lit = [](bool mirror, double regularize) {
    Scene scene;
    scene.camera = view({0.6, 0.8, 0.7}, {0.6, 0, 0}, 0.3);
    scene.objects = {object(floor_mesh(3), 0.8)};
    scene.lights = {make_light(
        "sphere", {{"center", Vec3d(0.7, 0.7, 0)}, {"radius", 0.01}, {"radiance", Vec3d(1000)}})};
    if (mirror) {
      mesh::Mesh wall;
      wall.positions = {{0, 0.001f, -3}, {0, 3, -3}, {0, 3, 3}, {0, 0.001f, 3}};
      wall.triangles = {{0, 1, 2}, {0, 2, 3}};
      Object glass = object(std::move(wall), 1);
      glass.material =
          make_material("surface", {{"metal", 1.0}, {"color", Vec3d(1)}, {"roughness", 0.03}});
      scene.objects.push_back(std::move(glass));
    } else {
      scene.lights.push_back(make_light(
          "sphere",
          {{"center", Vec3d(-0.7, 0.7, 0)}, {"radius", 0.01}, {"radiance", Vec3d(1000)}}));
    }
    Options o = options(32, 24, 64, 1);
    o.integrator = make_integrator("path", {{"regularize", regularize}});
    return mean_of(render(scene, o), "G");
  };
  const Mean image = lit(false, 0), dots = lit(true, 0), soft = lit(true, 0.25);
  EXPECT_NEAR(soft.value, image.value, 0.03 * image.value);
  // The mirror image contributes about a third of all light.
  EXPECT_NEAR(dots.value, image.value, 4 * dots.error);
  EXPECT_GT(dots.error, 3 * soft.error);
}

TEST(Render, ReportsBiasedSettings) {
  EXPECT_EQ(make_integrator("path")->inexact(), "");
  EXPECT_EQ(make_integrator("path", {{"clamp", 3.0}, {"regularize", 0.25}})->inexact(),
            "clamp 3, regularize 0.25");
}

TEST(Render, AnEmptySceneIsBlackAndZeroAreaTrianglesDoNoHarm) {
  Scene scene;
  scene.camera = view({0, 0, 3}, {0, 0, 0}, 1);
  EXPECT_EQ(mean_of(render(scene, options(8, 8, 2, 2)), "R").value, 0);
  mesh::Mesh mesh = floor_mesh(1);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({2, 2, 2});
  scene.objects = {object(mesh, 0.5)};
  scene.lights = {make_light("sky")};
  for (const float v : render(scene, options(16, 16, 4, 2)).pixels) EXPECT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace vug::render
