// SPDX-License-Identifier: Apache-2.0
#include "chi2.h"
#include "uniform.h"

#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::render {
namespace {

const NamedValues kView = {
    {"eye", Vec3d(1, 2, 3)}, {"target", Vec3d(1, 2, -7)}, {"fov", radians(kPi / 2)}};

TEST(Perspective, FovIsTheFullHorizontalAngle) {
  const CameraPtr camera = make_camera("perspective", kView);
  const float aspect = 16.0f / 9;
  const Vec3f middle = camera->ray({0.5f, 0.5f}, aspect, {0.5f, 0.5f}).direction;
  const Vec3f left = camera->ray({0, 0.5f}, aspect, {0.5f, 0.5f}).direction;
  const Vec3f top = camera->ray({0.5f, 0}, aspect, {0.5f, 0.5f}).direction;
  EXPECT_NEAR(length(middle - Vec3f(0, 0, -1)), 0, 1e-6);
  EXPECT_NEAR(dot(middle, left), std::cos(kPi / 4), 1e-6);
  EXPECT_LT(left.x, 0);  // left is -x when looking along -z with y up
  EXPECT_GT(top.y, 0);
  EXPECT_NEAR(top.y / -top.z, 1 / aspect, 1e-6);  // square pixels
}

TEST(Perspective, FocalLengthGivesTheAngleOfAPhotograph) {
  // The horizontal angle of a 24 mm lens on 35 mm film is 73.7 degrees.
  NamedValues parameters = kView;
  parameters.emplace_back("focal_length", 0.024);
  const auto half_angle = [](const CameraPtr& camera) {
    const Ray left = camera->ray({0, 0.5f}, 1.5f, {0.5f, 0.5f}),
              middle = camera->ray({0.5f, 0.5f}, 1.5f, {0.5f, 0.5f});
    return std::acos(dot(left.direction, middle.direction)) * 180 / static_cast<float>(kPi);
  };
  EXPECT_NEAR(half_angle(make_camera("perspective", parameters)), 73.74 / 2, 0.01);
  parameters.emplace_back("sensor_width", 0.048);
  EXPECT_NEAR(half_angle(make_camera("perspective", parameters)), 45, 0.01);
}

TEST(Perspective, LensKeepsTheFocusPlaneSharp) {
  NamedValues parameters = kView;
  parameters.emplace_back("aperture", 0.5);
  parameters.emplace_back("focus", 4.0);
  const CameraPtr camera = make_camera("perspective", parameters);
  const Vec2f film(0.3f, 0.8f);
  Vec3f meet(0.0f);
  for (int i = 0; i < 16; ++i) {
    const Vec2f lens(static_cast<float>(i % 4) / 4, static_cast<float>(i / 4) / 4);
    const Ray ray = camera->ray(film, 1.5f, lens);
    EXPECT_LE(length(ray.origin - Vec3f(1, 2, 3)), 0.25f + 1e-6f);
    const Vec3f at = ray.at((3 - 4 - ray.origin.z) / ray.direction.z);
    if (i == 0) meet = at;
    EXPECT_NEAR(length(at - meet), 0, 1e-5);
    EXPECT_NEAR(camera->depth(at), 4, 1e-5);
  }
}

// The matrices of the EXR header map points to the film positions of their rays.
TEST(Perspective, MatricesProjectPointsToTheFilm) {
  const CameraPtr camera = make_camera(
      "perspective", {{"eye", Vec3d(1, 2, 3)}, {"target", Vec3d(-2, 1, 0)}, {"fov", radians(1.1)}});
  const auto times = [](const Vec3f& p, const std::array<float, 16>& m) {
    std::array<float, 4> out{};
    for (size_t c = 0; c < 4; ++c)
      out[c] = p.x * m[c] + p.y * m[4 + c] + p.z * m[8 + c] + m[12 + c];
    return out;
  };
  const CameraMatrices m = camera->matrices(1.5f).value();
  for (const Vec2f& film : {Vec2f(0, 0), Vec2f(1, 1), Vec2f(0.3f, 0.8f), Vec2f(0.5f, 0.5f)}) {
    const Vec3f point = camera->ray(film, 1.5f, Vec2f(0.5f)).at(7);
    const auto ndc = times(point, m.world_to_ndc.value()), local = times(point, m.world_to_camera);
    EXPECT_NEAR(ndc[0] / ndc[3], film.x, 1e-5);
    EXPECT_NEAR(ndc[1] / ndc[3], film.y, 1e-5);
    EXPECT_NEAR(local[2], camera->depth(point), 1e-5);
    EXPECT_EQ(local[0] > 1e-4f, film.x > 0.5f) << "x is right";
    EXPECT_EQ(local[1] > 1e-4f, film.y < 0.5f) << "y is up";
  }
}

bool has_parameter(const KindInfo& info, const std::string& name) {
  for (const ParamInfo& p : info.params)
    if (p.name == name) return true;
  return false;
}

void expect_places(const Camera& camera, float aspect) {
  const auto matrices = camera.matrices(aspect);
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 200; ++i) {
    const Vec2f film = uniform_2d(random);
    const Ray ray = camera.ray(film, aspect, Vec2f(0.5f));
    EXPECT_NEAR(length(ray.direction), 1, 1e-6);
    const Vec3f point = ray.at(7);
    const auto place = camera.project(point, aspect);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, film.x, 1e-4);
    EXPECT_NEAR(place->y, film.y, 1e-5);
    EXPECT_GT(camera.depth(point), 0);
    if (!matrices || !matrices->world_to_ndc) continue;
    const auto& m = *matrices->world_to_ndc;
    const auto part = [&](size_t c) {
      return point.x * m[c] + point.y * m[4 + c] + point.z * m[8 + c] + m[12 + c];
    };
    EXPECT_NEAR(part(0) / part(3), film.x, 1e-4);
    EXPECT_NEAR(part(1) / part(3), film.y, 1e-4);
  }
}

TEST(EveryCamera, ProjectInvertsRay) {
  for (const auto* kind : cameras())
    for (const float aspect : {0.7f, 1.0f, 2.0f}) {
      SCOPED_TRACE(kind->info.name + ", aspect " + std::to_string(aspect));
      NamedValues parameters = {
          {"eye", Vec3d(1, 2, 3)}, {"target", Vec3d(-2, 1, 0)}, {"up", Vec3d(0.1, 1, 0)}};
      expect_places(*make_camera(kind->info.name, parameters), aspect);
      if (!has_parameter(kind->info, "interaxial")) continue;
      EXPECT_FALSE(make_camera(kind->info.name, parameters)->stereo_view(-1));
      parameters.emplace_back("interaxial", 0.2);
      for (const double convergence : {0.0, 5.0}) {
        if (convergence > 0) parameters.emplace_back("convergence", convergence);
        const CameraPtr both = make_camera(kind->info.name, parameters);
        for (const int side : {-1, 1}) expect_places(*both->stereo_view(side), aspect);
        const Vec2f middle(0.5f);
        EXPECT_NEAR(length(both->stereo_view(1)->ray(middle, aspect, middle).origin -
                           both->stereo_view(-1)->ray(middle, aspect, middle).origin),
                    0.2, 1e-6);
      }
    }
}

TEST(Stereo, DisparityIsZeroAtTheConvergenceAndInverseToDepth) {
  const CameraPtr camera = make_camera(
      "perspective", {{"fov", radians(kPi / 2)}, {"interaxial", 0.1}, {"convergence", 4.0}});
  const auto parallax = [&](float depth) {
    const Vec3f point(0.3f, -0.2f, 5 - depth);
    return camera->stereo_view(1)->project(point, 1.5f)->x -
           camera->stereo_view(-1)->project(point, 1.5f)->x;
  };
  EXPECT_NEAR(parallax(4), 0, 1e-6);
  for (const float depth : {1.0f, 2.0f, 9.0f})
    EXPECT_NEAR(parallax(depth), 0.1f / 2 * (1 / 4.0f - 1 / depth), 1e-6);
}

TEST(Stereo, PanoramaEyesAreOffsetPerpendicularly) {
  const CameraPtr camera = make_camera("panoramic", {{"interaxial", 0.1}});
  for (const float x : {0.0f, 0.2f, 0.5f, 0.9f}) {
    const Ray left = camera->stereo_view(-1)->ray({x, 0.5f}, 2, {});
    const Ray right = camera->stereo_view(1)->ray({x, 0.5f}, 2, {});
    EXPECT_NEAR(length(right.origin - left.origin), 0.1, 1e-6);
    EXPECT_NEAR(dot(right.origin - left.origin, left.direction), 0, 1e-6);
    EXPECT_NEAR(dot(right.origin - left.origin, cross(left.direction, Vec3f(0, 1, 0))), 0.1, 1e-6);
    const Ray up = camera->stereo_view(1)->ray({x, 0.02f}, 2, {});
    EXPECT_EQ(up.origin, camera->position()) << "at the zenith the eyes coincide";
  }
}

// Rays of uniform film positions hit a large sphere around the scene with the density with which
// the camera projects the sphere's points to the film.
TEST(EveryCamera, SamplesDirectionsUniformlyOnTheFilm) {
  constexpr float kBall = 20, kAspect = 1.5f;
  constexpr int kSamples = 200000;
  for (const auto* kind : cameras()) {
    SCOPED_TRACE(kind->info.name);
    const CameraPtr camera = make_camera(kind->info.name);  // at (0, 0, 5), looking at the origin
    const auto arrival = [&](const Vec2f& film) {
      const Ray ray = camera->ray(film, kAspect, Vec2f(0.5f));
      const float b = dot(ray.origin, ray.direction), c = dot(ray.origin, ray.origin);
      return normalized(ray.at(-b + std::sqrt(b * b - c + kBall * kBall)));
    };
    const Vec3f axis(0, 0, -1);
    double cap = 0;
    for (int i = 0; i <= 64; ++i)
      for (int j = 0; j <= 64; ++j)
        cap = std::max(
            cap, 1 - static_cast<double>(dot(
                         axis, arrival({static_cast<float>(i) / 64, static_cast<float>(j) / 64}))));
    cap = std::min(2.0, 1.1 * cap);
    const float step = 0.01f * static_cast<float>(std::sqrt(cap));
    const auto density = [&](const Vec3f& d) -> double {
      const Frame frame(d);
      Vec2f across[2];
      for (size_t i = 0; i < 2; ++i) {
        const Vec3f way = (i == 0 ? frame.x : frame.y) * (0.5f * step);
        const auto a = camera->project((d - way) * kBall, kAspect);
        const auto b = camera->project((d + way) * kBall, kAspect);
        if (!a || !b) return 0;
        across[i] = *b - *a;
        across[i].x -= std::round(across[i].x);  // across the seam of a panorama
      }
      const auto middle = camera->project(d * kBall, kAspect);
      if (!middle || middle->x < 0 || middle->x >= 1 || middle->y < 0 || middle->y >= 1) return 0;
      return static_cast<double>(std::fabs(across[0].x * across[1].y - across[0].y * across[1].x) /
                                 (step * step));
    };
    RandomStream random(RandomKey(4).at(kind->info.name));
    const Chi2 result = chi2(
        axis, cap, kSamples,
        [&](int) -> DirectionSample {
          const Vec3f d = arrival(uniform_2d(random));
          return {d, std::max(density(d), 1e-9)};
        },
        density);
    EXPECT_GT(result.p, 1 - std::pow(0.99, 1.0 / static_cast<double>(cameras().size())));
    EXPECT_NEAR(result.integral, 1, 5e-3);
    EXPECT_LT(result.stray, kSamples / 5000);
  }
}

TEST(EveryCamera, SamplesItsApertureUniformly) {
  constexpr int kCells = 16, kFine = 32, kSamples = 100000;
  constexpr double kRadius = 0.25, kTurn = 0.3;
  int found = 0;
  for (const auto* kind : cameras()) {
    if (!has_parameter(kind->info, "blades")) continue;
    for (const int blades : {0, 3, 5, 8}) {
      SCOPED_TRACE(kind->info.name + ", blades " + std::to_string(blades));
      const CameraPtr camera = make_camera(
          kind->info.name,
          {{"aperture", 2 * kRadius}, {"blades", blades}, {"blade_turn", radians(kTurn)}});
      const auto inside = [&](double x, double y) {
        if (blades == 0) return x * x + y * y < 1;
        for (int i = 0; i < blades; ++i) {  // the side of the polygon between two corners
          const double angle = kPi / 2 + kTurn + (2 * i + 1) * kPi / blades;
          if (x * std::cos(angle) + y * std::sin(angle) > std::cos(kPi / blades)) return false;
        }
        return true;
      };
      std::vector<double> expected(kCells * kCells, 0), seen(kCells * kCells, 0);
      const auto cell = [&](double x, double y) -> double& {
        const int i = std::min(kCells - 1, static_cast<int>((x + 1) / 2 * kCells));
        const int j = std::min(kCells - 1, static_cast<int>((y + 1) / 2 * kCells));
        return seen[static_cast<size_t>(j * kCells + i)];
      };
      double area = 0;
      for (int i = 0; i < kCells * kFine; ++i)
        for (int j = 0; j < kCells * kFine; ++j) {
          const bool in =
              inside(2 * (i + 0.5) / (kCells * kFine) - 1, 2 * (j + 0.5) / (kCells * kFine) - 1);
          area += in, expected[static_cast<size_t>(j / kFine * kCells + i / kFine)] += in;
        }
      RandomStream random(RandomKey(5).at(static_cast<uint64_t>(blades)));
      for (int i = 0; i < kSamples; ++i) {
        const Vec3f at = camera->ray({0.3f, 0.8f}, 1.5f, uniform_2d(random)).origin;
        ASSERT_NEAR(at.z, 5, 1e-6);
        ASSERT_TRUE(inside(0.9999 * static_cast<double>(at.x) / kRadius,
                           0.9999 * static_cast<double>(at.y) / kRadius));
        cell(static_cast<double>(at.x) / kRadius, static_cast<double>(at.y) / kRadius) += 1;
      }
      double statistic = 0;
      int cells = 0;
      for (size_t i = 0; i < expected.size(); ++i) {
        const double e = expected[i] / area * kSamples;
        if (e < 20) continue;  // slivers at the edge, where the quadrature is coarse
        statistic += (seen[i] - e) * (seen[i] - e) / e, ++cells;
      }
      EXPECT_GT(chi2_tail(statistic, cells - 1), 0.0025);
      ++found;
    }
  }
  EXPECT_GT(found, 0);
}

TEST(Orthographic, RaysAreParallelAndSpanTheWidth) {
  const CameraPtr camera = make_camera(
      "orthographic", {{"eye", Vec3d(1, 2, 3)}, {"target", Vec3d(1, 2, 0)}, {"width", 6.0}});
  const Ray left = camera->ray({0, 0.5f}, 2, Vec2f(0.5f)), top = camera->ray({0.5f, 0}, 2, {});
  EXPECT_EQ(left.direction, top.direction);
  EXPECT_NEAR(length(left.origin - Vec3f(-2, 2, 3)), 0, 1e-6);
  EXPECT_NEAR(length(top.origin - Vec3f(1, 3.5f, 3)), 0, 1e-6);
  EXPECT_NEAR(camera->depth({9, 9, -1}), 4, 1e-6);
  EXPECT_FALSE(camera->project({0, 0, 4}, 2)) << "behind";
}

TEST(Panoramic, MapsLongitudeAndLatitude) {
  const CameraPtr all = make_camera("panoramic", {{"target", Vec3d(0, 0, 0)}});
  const auto way = [&](float x, float y) { return all->ray({x, y}, 2, Vec2f(0.5f)).direction; };
  EXPECT_NEAR(length(way(0.5f, 0.5f) - Vec3f(0, 0, -1)), 0, 1e-6);
  EXPECT_NEAR(length(way(0.75f, 0.5f) - Vec3f(1, 0, 0)), 0, 1e-6) << "right is to the right";
  EXPECT_NEAR(length(way(0, 0.5f) - Vec3f(0, 0, 1)), 0, 1e-6) << "the edge looks back";
  EXPECT_NEAR(length(way(0.3f, 0) - Vec3f(0, 1, 0)), 0, 1e-6) << "the top line is the zenith";
  EXPECT_NEAR(way(0.5f, 0.25f).y, std::sqrt(0.5f), 1e-6);
  const CameraPtr part =
      make_camera("panoramic", {{"horizontal", radians(kPi)}, {"vertical", radians(kPi / 2)}});
  EXPECT_NEAR(length(part->ray({1, 0.5f}, 2, {}).direction - Vec3f(1, 0, 0)), 0, 1e-6);
  EXPECT_NEAR(part->ray({0.5f, 0}, 9, {}).direction.y, std::sqrt(0.5f), 1e-6);
  EXPECT_FALSE(all->matrices(2)->world_to_ndc) << "no matrix bends";
}

TEST(Perspective, RejectsDegenerateFrames) {
  EXPECT_THROW(make_camera("perspective", {{"blades", 2}}), Error);
  EXPECT_THROW(make_camera("perspective", {{"eye", Vec3d(0, 0, 0)}, {"target", Vec3d(0, 0, 0)}}),
               Error);
  EXPECT_THROW(make_camera("perspective", {{"eye", Vec3d(0, 0, 0)}, {"target", Vec3d(0, 5, 0)}}),
               Error);
  EXPECT_THROW(make_camera("perspective", {{"fov", radians(0)}}), Error);
}

}  // namespace
}  // namespace vug::render
