#include <vug/base/error.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::render {
namespace {

const Named kView = {
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

TEST(Perspective, LensKeepsTheFocusPlaneSharp) {
  Named parameters = kView;
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

// What the EXR's header says of the camera sends points to where their rays were.
TEST(Perspective, MatricesSayWhereThePictureShowsAPoint) {
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
    const auto ndc = times(point, m.world_to_ndc), local = times(point, m.world_to_camera);
    EXPECT_NEAR(ndc[0] / ndc[3], film.x, 1e-5);
    EXPECT_NEAR(ndc[1] / ndc[3], film.y, 1e-5);
    EXPECT_NEAR(local[2], camera->depth(point), 1e-5);
    EXPECT_EQ(local[0] > 1e-4f, film.x > 0.5f) << "x is right";
    EXPECT_EQ(local[1] > 1e-4f, film.y < 0.5f) << "y is up";
  }
}

TEST(Perspective, RefusesViewsThatAreNone) {
  EXPECT_THROW(make_camera("perspective", {{"eye", Vec3d(0, 0, 0)}, {"target", Vec3d(0, 0, 0)}}),
               Error);
  EXPECT_THROW(make_camera("perspective", {{"eye", Vec3d(0, 0, 0)}, {"target", Vec3d(0, 5, 0)}}),
               Error);
  EXPECT_THROW(make_camera("perspective", {{"fov", radians(0)}}), Error);
}

}  // namespace
}  // namespace vug::render
