// SPDX-License-Identifier: Apache-2.0
// Lamps for shots, and the fit of their powers.
#include "rooms.h"

#include <vug/base/parallel.h>
#include <vug/scout/key_ratio.h>
#include <vug/scout/scout.h>
#include <vug/scout/shot_text.h>
#include <vug/scout/trace_view.h>

#include <cmath>
#include <set>

namespace vug::scout {
namespace {

const std::vector<std::filesystem::path> kData = {VUG_DATA};

std::string dark_hall() {
  return hall("camera main { eye (-10, 1.6, 0)  target (4, 1.6, 0)  fov 60deg }\n",
              " + box(size: (3, 10, 2.2)).translate((4, 3, 2.2))"
              " + box(size: (1.5, 1.2, 1.5)).translate((-1, 0.4, -1))");
}

TEST(Fit, IsExactWhereTheSolutionIsPositive) {
  const NonNegativeFit fit = fit_non_negative({{2, 1, 0}, {0, 1, 3}}, {4, 5, 9});
  ASSERT_EQ(fit.weights.size(), 2u);
  EXPECT_NEAR(fit.weights[0], 2, 1e-9);
  EXPECT_NEAR(fit.weights[1], 3, 1e-9);
  EXPECT_NEAR(fit.residual, 0, 1e-15);
}

TEST(Fit, MeetsTheConditionsOfTheConstrainedMinimum) {
  const std::vector<std::vector<double>> columns = {{1, 0.2, 0.9}, {0.3, 1, 0.1}, {0, 0, 0}};
  const std::vector<double> target = {1, -2, 0.5};
  const NonNegativeFit fit = fit_non_negative(columns, target);
  std::vector<double> rest = target;
  for (size_t j = 0; j < 3; ++j)
    for (size_t i = 0; i < 3; ++i) rest[i] -= fit.weights[j] * columns[j][i];
  for (size_t j = 0; j < 3; ++j) {  // Karush, Kuhn and Tucker
    double slope = 0;
    for (size_t i = 0; i < 3; ++i) slope += columns[j][i] * rest[i];
    EXPECT_GE(fit.weights[j], 0);
    if (fit.weights[j] > 0) {
      EXPECT_NEAR(slope, 0, 1e-9) << j;
    } else {
      EXPECT_LE(slope, 1e-9) << j;
    }
  }
  EXPECT_EQ(fit.weights[1], 0);
  EXPECT_EQ(fit.weights[2], 0) << "a column of zeros";
}

/// Light of each lamp on the first part.
std::vector<double> on_subject(const std::vector<std::vector<double>>& columns,
                               const NonNegativeFit& fit) {
  std::vector<double> light;
  for (size_t j = 0; j < columns.size(); ++j) light.push_back(fit.weights[j] * columns[j][0]);
  return light;
}

TEST(KeyRatio, LimitsTheLightOfTheOtherLampsOnTheSubject) {
  const std::vector<std::vector<double>> columns = {{1, 0.1, 0.3}, {0.8, 0.7, 0.1}, {0.5, 0, 1}};
  const std::vector<double> target = {1, 0.6, 0.9};
  const auto plain = on_subject(columns, fit_non_negative(columns, target));
  ASSERT_GT(4 * (plain[0] + plain[2]), plain[1]) << "without the ratio, it is not held";
  for (const double ratio : {4.0, 8.0, 50.0}) {
    const auto light = on_subject(columns, fit_with_key(columns, target, {0, ratio, 0}));
    EXPECT_GE(1.01 * light[1], ratio * (light[0] + light[2])) << ratio;
    EXPECT_LE(0.9 * light[1], ratio * (light[0] + light[2])) << "and no lower than needed";
    EXPECT_GT(light[1], 0.3);
  }
}

TEST(KeyRatio, ChangesNothingWhereItIsHeldAnyway) {
  const std::vector<std::vector<double>> columns = {{1, 0.1}, {0.05, 0.7}};
  const NonNegativeFit plain = fit_non_negative(columns, {1, 0.6});
  EXPECT_EQ(fit_with_key(columns, {1, 0.6}, {0, 8, 0}).weights, plain.weights);
}

TEST(KeyRatio, UnderASkyAllLampsAreFill) {
  const std::vector<std::vector<double>> columns = {{0.6, 0.4}, {0.9, 1}};
  const auto light = on_subject(columns, fit_with_key(columns, {0.5, 2}, {0, 8, 1}));
  EXPECT_NEAR(light[0] + light[1], 1.0 / 8, 0.01);
}

TEST(Lamps, TheTextOfALampIsOneOfTheKit) {
  const std::vector<Lamp> lamps = {{LampRole::key, {1, 2, 3}, {4, 1, 3}, 5000},
                                   {LampRole::glow, {0, 1, 0}, {0, 0, 0}, 300},
                                   {LampRole::glow, {0, 2, 0}, {0, 0, 0}, 200},
                                   {LampRole::lantern, {2, 0.6, 0}, {0, 0, 0}, 600}};
  EXPECT_EQ(lamps_text(lamps, "shot2_", "kit"),
            "include \"kit/lamps.vug\" as kit\n"
            "light shot2_key     = kit.led_panel((1, 2, 3), towards: (4, 1, 3), level: 5000, "
            "temperature: 4000K)\n"
            "light shot2_glow    = kit.bulb((0, 1, 0), level: 300, temperature: 7500K)\n"
            "light shot2_glow2   = kit.bulb((0, 2, 0), level: 200, temperature: 7500K)\n"
            "light shot2_lantern = kit.lantern((2, 0.6, 0), level: 600)\n");
  const auto lights = lights_of(lamps, kData);
  ASSERT_EQ(lights.size(), 4u);
  for (size_t i = 0; i < 4; ++i)
    EXPECT_LT((Vec3d(lights[i]->center()) - lamps[i].at).length(), 1e-5);
  EXPECT_THROW(lights_of(lamps, {}), Error);
}

TEST(Lamps, PlacesAreInTheAirAndOutOfThePicture) {
  const Room room(dark_hall());
  EXPECT_FALSE(room.location.lit);
  EXPECT_TRUE(room.location.scene.lights.empty()) << "without the default sky";
  const render::Camera& camera = *room.loaded.shot.cameras[0].camera;
  const auto lamps = lamp_places(room.location, camera, trace_view(*room.location.world, camera),
                                 {}, RandomKey(1));
  EXPECT_GE(lamps.size(), 6u);
  EXPECT_LE(lamps.size(), 24u);
  std::set<LampRole> roles;
  for (const Lamp& each : lamps) {
    roles.insert(each.role);
    EXPECT_GT(clearance(*room.location.world, each.at), 0.15);
    const auto film = camera.project(Vec3f(each.at), 64.0f / 36);
    if (!film || film->x < 0 || film->x > 1 || film->y < 0 || film->y > 1) continue;
    const Vec3d eye(camera.position()), way = each.at - eye;
    EXPECT_LT(static_cast<double>(look_along(*room.location.world, eye, way).distance),
              way.length())
        << "a lamp in the frame is hidden by rock";
  }
  EXPECT_GE(roles.size(), 2u);
}

TEST(Lamps, ADarkHallGetsAMixThatIsNeitherBlackNorFlat) {
  const Room room(dark_hall());
  const render::Camera& camera = *room.loaded.shot.cameras[0].camera;
  const auto choose = [&](int threads) {
    return with_threads(
        threads, [&] { return choose_lamps(room.location, camera, kData, {}, RandomKey(1)); });
  };
  const std::vector<Lamp> lamps = choose(1);
  ASSERT_GE(lamps.size(), 1u);
  EXPECT_LE(lamps.size(), 4u);
  for (const Lamp& each : lamps) {
    EXPECT_LE(each.lumen, most_lumens(each.role));
    const double digits = each.lumen / std::pow(10, std::floor(std::log10(each.lumen) + 1e-9));
    EXPECT_TRUE(digits == 1 || digits == 1.5 || digits == 2 || digits == 3 || digits == 5 ||
                digits == 8)
        << each.lumen << " lm are not those of a product";
  }
  const View view = trace_view(*room.location.world, camera);
  const auto luminance =
      illuminate(*room.location.world, lights_of(lamps, kData), view, RandomKey(2));
  EXPECT_LE(light_terms(luminance, view).black, 0.5);
  EXPECT_GE(light_terms(luminance, view).bright, 0.02);
  EXPECT_EQ(lamps_text(choose(2), "", "k"), lamps_text(lamps, "", "k"));
  EXPECT_EQ(lamps_text(choose(7), "", "k"), lamps_text(lamps, "", "k"));
}

/// The mean light of each lamp on the subject of a view.
std::vector<double> light_on_subject(const Room& room, const std::vector<Lamp>& lamps,
                                     const View& view) {
  const std::vector<Part> parts = parts_of(view, {});
  std::vector<double> light;
  for (const render::LightPtr& each : lights_of(lamps, kData)) {
    const auto luminance = illuminate(*room.location.world, {each}, view, RandomKey(5));
    double sum = 0;
    for (size_t i = 0; i < parts.size(); ++i)
      if (parts[i] == Part::subject) sum += static_cast<double>(luminance[i]);
    light.push_back(sum);
  }
  return light;
}

TEST(Lamps, TheKeyHoldsItsRatioToAllOthers) {
  const Room room(dark_hall());
  const render::Camera& camera = *room.loaded.shot.cameras[0].camera;
  const View view = trace_view(*room.location.world, camera);
  for (const double ratio : {1.5, 8.0, 60.0}) {
    const auto lamps = choose_lamps(room.location, camera, kData, {}, RandomKey(1), ratio);
    const std::vector<double> light = light_on_subject(room, lamps, view);
    double all = 0, key = 0;
    for (const double each : light) all += each, key = std::max(key, each);
    // Powers are rounded to those of products, by up to 1.29 each.
    EXPECT_GT(key * 1.7, ratio * (all - key)) << ratio;
  }
}

TEST(Lamps, RelightingReplacesTheLampsButNotTheSky) {
  const std::string lights =
      "light lamp = sphere(center: (2, 4, 0), radius: 20cm, lumen: 3000)\n"
      "light dome = sky(radiance: (1, 1, 1))\n";
  const loading::Loaded loaded = loading::load_text(dark_hall() + lights, "t.vug");
  building::Builder builder(loaded.shot);
  const auto plan = picture::plan_picture(loaded.shot);
  EXPECT_EQ(prepare_location(builder, plan).scene.lights.size(), 2u);
  EXPECT_TRUE(prepare_location(builder, plan).lit);
  const Location relit = prepare_location(builder, plan, true);
  EXPECT_FALSE(relit.lit);
  EXPECT_TRUE(relit.sky_shines);
  ASSERT_EQ(relit.scene.lights.size(), 1u);
  EXPECT_TRUE(relit.scene.lights[0]->is_infinite());
}

}  // namespace
}  // namespace vug::scout
