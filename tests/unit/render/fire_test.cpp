// SPDX-License-Identifier: Apache-2.0
// Grids of colour, temperature and flame in addition to a density, against quadrature. fire.vdb was
// written with pyopenvdb: blocks of 4 x 4 voxels of 50 cm about the y and z axes, constant except
// for the temperature, which rises along z by 100 K per voxel from 1600 K; the flame begins 3
// voxels further.
#include "scenes.h"

#include <vug/paint/kind.h>
#include <vug/render/lighting/blackbody.h>
#include <vug/volume/density.h>

#include <gtest/gtest.h>

#include <array>

namespace vug::render {
namespace {

constexpr double kExtinction = 1.1;

MediumPtr fire(NamedValues more) {
  more.emplace_back("file", VUG_TEST_DATA "/volumes/fire.vdb");
  more.emplace_back("extinction", kExtinction);
  return make_medium("cloud", more);
}

/// Values at the lattice of the file (0 outside it), interpolated.
double integral_along_z(double z, int first, double start, double step) {
  const double place = (z + 0.75) / 0.5, low = std::floor(place);
  const auto value = [&](double k) { return k >= first && k < first + 4 ? start + step * k : 0.0; };
  return value(low) + (place - low) * (value(low + 1) - value(low));
}
double density(double z) { return integral_along_z(z, 0, 0.8, 0); }
double kelvin(double z) { return integral_along_z(z, 0, 1600, 100); }
double flame(double z) { return integral_along_z(z, 3, 0.5, 0); }

/// Radiance at z = 5 along the z axis, for a given emission per metre.
Rgb quadrature_of_fire(const std::function<Vec3d(double)>& sent) {
  constexpr int kSteps = 40000;
  constexpr double kFrom = 4, kTo = -2, kStep = (kFrom - kTo) / kSteps;
  double depth = 0;
  Vec3d sum(0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double z = kFrom - kStep * (i + 0.5), here = kExtinction * density(z) * kStep;
    sum += sent(z) * (std::exp(-depth - 0.5 * here) * kStep);
    depth += here;
  }
  return Rgb(sum);
}
Vec3d heat(double z) { return Vec3d(thermal_radiance(static_cast<float>(kelvin(z)))); }

void expect_seen(const MediumPtr& medium, const Rgb& expected) {
  Scene scene;
  scene.camera = view({0, 0, 5}, {0, 0, 0}, 1e-4);
  scene.medium = medium;
  const image::Image picture = render(scene, options(32, 32, 256, 0));
  const char* names[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    const Mean mean = mean_of(picture, names[c]);
    const auto value = static_cast<double>(expected[c]);
    EXPECT_NEAR(mean.value, value, 4 * mean.error + 1e-4 * value) << names[c];
    EXPECT_LE(mean.error, 0.01 * value);
  }
}

TEST(Fire, PlatinumFreezesAtSixtyCandelas) {
  // 2041.4 K; the fit of the colour matching functions is accurate to about 1 %.
  EXPECT_NEAR(static_cast<double>(luminance(thermal_radiance(2041.4f))) * kLumenPerWatt, 6e5, 6e3);
  EXPECT_TRUE(is_black(thermal_radiance(290)));
  EXPECT_TRUE(is_black(thermal_radiance(-1)));
  for (const float t : {800.0f, 1500.0f, 6000.0f, 30000.0f}) {
    const Rgb a = thermal_radiance(t), b = thermal_radiance(t * 1.001f);
    const float steep = std::log(luminance(b) / luminance(a)) / std::log(1.001f);
    // Wien's law at one wavelength about 560 nm.
    const double x = 1.438776877e7 / (560 * static_cast<double>(t));
    EXPECT_NEAR(static_cast<double>(steep), x / (1 - std::exp(-x)), 0.12 * x) << t;
  }
}

TEST(Fire, FlamesEmitIndependentlyOfTheDensity) {
  const Vec3d radiance(3, 2, 1);
  expect_seen(fire({{"albedo", Vec3d(0)}, {"emission", radiance}, {"emission_grid", "flame"}}),
              quadrature_of_fire([&](double z) { return radiance * flame(z); }));
  // From behind, through the smoke; and only flames.
  EXPECT_EQ(kExtinction * density(2), 0);
  EXPECT_GT(flame(2), 0);
}

TEST(Fire, HeatEmissionIsProportionalToExtinction) {
  expect_seen(
      fire({{"albedo", Vec3d(0)}, {"temperature_grid", "temperature"}, {"temperature", 1.0}}),
      quadrature_of_fire([](double z) { return heat(z) * (kExtinction * density(z)); }));
}

TEST(Fire, FlamesTakeTheirTemperatureFromTheGrid) {
  const Vec3d more(2, 0, 1);
  expect_seen(fire({{"albedo", Vec3d(0)},
                    {"emission", more},
                    {"emission_mask", 0.5},
                    {"emission_grid", "flame"},
                    {"temperature_grid", "temperature"},
                    {"temperature", 1.0}}),
              quadrature_of_fire([&](double z) { return (heat(z) + more) * (0.5 * flame(z)); }));
}

TEST(Fire, MasksReplaceGrids) {
  const auto mask = [](double z) { return 0.5 + 0.1 * z; };
  const paint::Mask by_place =
      paint::make_mask([mask](const paint::EvalPoint& s) { return mask(s.position.z); });
  const Value value = ValueTraits<paint::Mask>::write(by_place);
  expect_seen(fire({{"albedo", Vec3d(0)}, {"temperature_mask", value}, {"temperature", 3000.0}}),
              quadrature_of_fire([&](double z) {
                return Vec3d(thermal_radiance(static_cast<float>(3000 * mask(z)))) *
                       (kExtinction * density(z));
              }));
}

// In a white sky a colour with albedo 1 vanishes, one with albedo 0 is only attenuated, and one
// between looks as if the whole cloud had that albedo.
TEST(Fire, ColoursOfTheGridAreAlbedos) {
  const auto picture = [](const NamedValues& colour) {
    Scene scene;
    scene.camera = view({0, 0, 5}, {0, 0, 0}, 1e-4);
    scene.lights = {make_light("sky")};
    scene.medium = fire(colour);
    Options o = options(24, 24, 256, 200);
    o.openings = false;
    return render(scene, o);
  };
  const image::Image colours = picture({{"albedo", Vec3d(1)}, {"color_grid", "Cd"}});
  const Mean white = mean_of(colours, "R"), grey = mean_of(colours, "G"),
             black = mean_of(colours, "B");
  EXPECT_NEAR(white.value, 1, 4 * white.error);
  EXPECT_LT(white.error, 3e-3);
  // 3 voxels of 0.8, and one more at the ramps, of 50 cm.
  EXPECT_NEAR(black.value, std::exp(-kExtinction * 0.8 * 2), 4 * black.error + 1e-5);
  const Mean even = mean_of(picture({{"albedo", Vec3d(0.5)}}), "G");
  EXPECT_NEAR(grey.value, even.value, 4 * std::hypot(grey.error, even.error));
  EXPECT_GT(even.value - black.value, 20 * even.error);
  const paint::Paint paint = paint::make_paint(
      [](const paint::EvalPoint& s) { return Vec3d(s.position.y < 9 ? 0.5 : 0); });
  const Mean painted = mean_of(picture({{"albedo", ValueTraits<paint::Paint>::write(paint)}}), "G");
  EXPECT_NEAR(painted.value, even.value, 4 * std::hypot(painted.error, even.error));
}

// With the grid names that other programs expect, in kelvin, and where they vary.
TEST(Fire, IsExportedAsGrids) {
  const auto exported = [](const NamedValues& more) {
    return fire(more)->as_data(nullptr).value();
  };
  const auto named = [](const MediumData& data, const std::string& name) {
    for (const volume::Grid& grid : data.grids)
      if (grid.name() == name) return volume::Density(grid);
    throw std::runtime_error("no grid " + name);
  };
  const MediumData plain =
      exported({{"albedo", Vec3d(0.5)}, {"g", 0.25}, {"emission", Vec3d(1, 2, 3)}});
  ASSERT_EQ(plain.grids.size(), 1u);
  EXPECT_EQ(plain.grids[0].name(), "density");
  EXPECT_EQ(plain.medium.extinction, kExtinction);
  EXPECT_EQ(plain.medium.albedo, Vec3d(0.5));
  EXPECT_EQ(plain.medium.forward, 0.25);
  EXPECT_EQ(plain.medium.emission, Vec3d(1, 2, 3));
  EXPECT_EQ(plain.medium.heat, 0);

  const MediumData whole = exported({{"albedo", Vec3d(0.5)},
                                     {"color_grid", "Cd"},
                                     {"emission_mask", 0.5},
                                     {"emission_grid", "flame"},
                                     {"temperature_grid", "temperature"},
                                     {"temperature", 2.0}});
  std::vector<std::string> names;
  for (const volume::Grid& grid : whole.grids) names.push_back(grid.name());
  EXPECT_EQ(names, (std::vector<std::string>{"density", "color", "temperature", "flame"}));
  EXPECT_EQ(whole.medium.albedo, Vec3d(1));
  EXPECT_EQ(whole.medium.heat, 1);
  const Vec3f middle(0, 0, 0.25f);  // a point of the lattice
  const double z = 0.25;
  EXPECT_NEAR(named(whole, "density").at_world(middle), density(z), 1e-5);
  EXPECT_NEAR(named(whole, "temperature").at_world(middle), 2 * kelvin(z), 3e-2);
  EXPECT_NEAR(named(whole, "flame").at_world({0, 0, 1.75f}), 0.5 * flame(1.75), 1e-5);
  for (const volume::Grid& grid : whole.grids)
    if (grid.name() == "color") {
      const float wanted[] = {0.5f, 0.25f, 0};  // the grid's times the albedo
      for (int part = 0; part < 3; ++part)
        EXPECT_NEAR(volume::Density(grid, part).at_world(middle), wanted[part], 1e-5);
    }
  EXPECT_FALSE(make_medium("haze")->as_data(nullptr));
}

TEST(Fire, MissingGridsAreReported) {
  try {
    fire({{"temperature_grid", "temperature2"}, {"temperature", 1.0}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'temperature2'"), std::string::npos);
    EXPECT_NE(error.hint().find("temperature"), std::string::npos);
  }
  EXPECT_THROW(fire({{"temperature_grid", "temperature"}}), Error);  // the unit is missing
  EXPECT_THROW(make_medium("cloud", {{"emission_grid", "flame"}}), Error);
}

}  // namespace
}  // namespace vug::render
