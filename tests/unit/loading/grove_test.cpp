// SPDX-License-Identifier: Apache-2.0
// grove(...) in scenes: the positions of its plants, and the reports of faults.
#include <vug/base/scratch_folder.h>
#include <vug/building/flat_scene.h>
#include <vug/image/io.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace vug::loading {
namespace {

constexpr const char* kThings = R"(
seed 5
volume small = level_set(cylinder(radius: 5cm, height: 1m).translate((0, 0.5, 0)), voxel: 2cm)
volume large = level_set(cylinder(radius: 10cm, height: 2m).translate((0, 1, 0)), voxel: 2cm)
mesh small_mesh on small {}
mesh large_mesh on large {}
object thin on small_mesh {}
object thick on large_mesh {}
let hill = sphere(radius: 20m).translate((0, -18, 0))
)";

/// The instances.
building::FlatScene cast(const std::string& text) {
  const Loaded scene = load_text(kThings + text, "t.vug");
  EXPECT_TRUE(scene.usable()) << scene.report();
  building::Builder builder(scene.shot);
  building::FlatScene made = building::flatten_scene(builder);
  std::erase_if(made.objects, [](const render::Object& object) { return !object.instance; });
  return made;
}
std::string grove_faults(const std::string& text) {
  return load_text(std::string(kThings) + "place p { of thin  at grove(" + text + ") }\n", "t.vug")
      .report();
}

Vec3d origin(const render::Object& object) { return Vec3d(object.instance->at(0).origin); }

TEST(GrovePlaces, DensityIsThatOfAHectare) {
  const building::FlatScene made = cast(
      "place p { of [thin, thick]  at grove(polygon: [(0, 0), (50, 0), (50, 20), (0, 20)], "
      "density: "
      "4000) }\n");
  EXPECT_EQ(made.objects.size(), 400u);
  for (const render::Object& object : made.objects) EXPECT_EQ(origin(object).y, 0);
}

TEST(GrovePlaces, StandOnTheHillOutOfTheRockAndLean) {
  const building::FlatScene made = cast(
      "place p { of thin  at grove(polygon: [(-9, -9), (9, -9), (9, 9), (-9, 9)], count: 500, on: "
      "hill, "
      "avoid: [sphere(radius: 3m).translate((3, 2, 0))], lean: 10deg, lean_to: (1, 0, 0), sink: "
      "10cm) }\n");
  ASSERT_GT(made.objects.size(), 300u);
  ASSERT_LT(made.objects.size(), 500u);
  for (const render::Object& object : made.objects) {
    const Vec3d at = origin(object) + Vec3d(0, 0.1, 0);
    EXPECT_NEAR((at - Vec3d(0, -18, 0)).length(), 20, 1e-4);
    EXPECT_GT((at - Vec3d(3, 2, 0)).length(), 3 - 1e-4);
    const Vec3d up(object.instance->at(0).y);
    EXPECT_GE(up.x, -1e-6);
    EXPECT_NEAR(up.z, 0, 1e-6);
    EXPECT_GE(up.y, std::cos(10 * kPi / 180) - 1e-6);
  }
}

TEST(GrovePlaces, StandOnAMeshInTheSameWay) {
  const std::string on_mesh =
      "volume earth = level_set(hill, voxel: 25cm, from: (-10, -2, -10), to: (10, 3, 10))\n"
      "mesh ground on earth {}\n"
      "place p { of thin  at grove(polygon: [(-5, -5), (5, -5), (5, 5), (-5, 5)], count: 200, on: ";
  const building::FlatScene by_mesh = cast(on_mesh + "ground) }\n"),
                            by_field = cast(on_mesh + "earth) }\n");
  ASSERT_EQ(by_mesh.objects.size(), by_field.objects.size());
  for (size_t i = 0; i < by_mesh.objects.size(); ++i)
    EXPECT_LT((origin(by_mesh.objects[i]) - origin(by_field.objects[i])).length(), 0.01);
}

TEST(GrovePlaces, StandOnAPictureWhereItIsNotTooSteep) {
  // A roof: a slope of 1:2 up from the left edge to the middle, a slope of 3:2 down to a third
  // before the right edge, then level.
  image::Image heights(241, 3, {"Y"});
  const auto height = [](double x) {  // metres, x from -12 to 12
    return x < 0 ? 6 + x / 2 : std::max(0.0, 6 - 1.5 * x);
  };
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 241; ++x) heights.at(x, y) = static_cast<float>(height(0.1 * x - 12) / 8);
  const ScratchFolder scratch("vug_grove");
  const auto path = scratch.file("heights.exr");
  image::write_exr(path, heights, {});
  const building::FlatScene made = cast(
      "let land = heightfield(file: \"" + path.string() +
      "\", size: (24m, 8m, 24m), sampling: bilinear)\n"
      "place p { of thin  at grove(polygon: [(-11, -9), (11, -9), (11, 9), (-11, 9)], count: 600, "
      "on: land, steepest: 40deg) }\n");
  int left = 0, right = 0;
  for (const render::Object& object : made.objects) {
    const Vec3d at = origin(object);
    EXPECT_NEAR(at.y, height(at.x), 0.06) << at;
    (at.x < 0 ? left : right) += 1;
    EXPECT_FALSE(at.x > 0.2 && at.x < 3.8) << "that is 56 degrees steep: " << at;
  }
  EXPECT_NEAR(left, 300, 60);
  EXPECT_NEAR(right, 600 * 7.0 / 22, 60);
}

TEST(GrovePlaces, DiametersChooseTheModelAndItsSize) {
  const building::FlatScene made = cast(
      "place p { of [thin, thick]  at grove(polygon: [(0, 0), (40, 0), (40, 40), (0, 40)], count: "
      "2000, "
      "diameter: 14cm, diameter_spread: 3cm, diameters: [10cm, 20cm], height_power: 0.629) }\n");
  ASSERT_EQ(made.objects.size(), 2000u);
  size_t thick = 0;
  double sum = 0;
  for (const render::Object& object : made.objects) {
    double width = 0;
    for (const Vec3f& p : object.mesh->positions)
      width = std::max(width, 2 * static_cast<double>(p.x));
    thick += width > 0.15;
    const render::Affine to = object.instance->at(0);
    EXPECT_NEAR(std::log(to.y.length()), 0.629 * std::log(to.x.length()), 1e-5);
    const double diameter = width * static_cast<double>(to.x.length());
    EXPECT_NEAR(diameter, 0.14, 2.5 * 0.03 + 0.005);
    if (std::fabs(diameter - 0.1414) > 0.003) {  // the nearest by ratio
      EXPECT_EQ(width > 0.15, diameter > 0.1414);
    }
    sum += diameter;
  }
  EXPECT_NEAR(sum / 2000, 0.14, 0.005);
  EXPECT_NEAR(static_cast<double>(thick), 960, 100);
}

/// The warnings while the instances are computed.
std::string warnings(const std::string& grove) {
  const Loaded scene =
      load_text(std::string(kThings) + "place p { of thin  at grove(" + grove + ") }\n", "t.vug");
  EXPECT_TRUE(scene.usable()) << scene.report();
  Diagnostics all;
  building::BuildOptions options;
  options.on_warning = [&](const Diagnostics& more) { all.append(more); };
  building::Builder builder(scene.shot, options);
  try {
    building::flatten_scene(builder);
  } catch (const Error& error) {
    all.error(error.where(), error.what(), error.hint());
  }
  return scene.report(all);
}

TEST(GrovePlaces, ReasonsForNoInstances) {
  const std::string square = "polygon: [(30, 30), (39, 30), (39, 39), (30, 39)], count: 20";
  const auto hint = [&](const std::string& more) {
    const std::string said = warnings(square + more);
    EXPECT_NE(said.find("t.vug:10:7: warning: 'p' has no instances"), std::string::npos) << said;
    return said.substr(std::min(said.find("hint: "), said.size()));
  };
  EXPECT_EQ(hint(", on: hill"), "hint: of its points, 20 without ground below\n");
  EXPECT_EQ(hint(", avoid: [box(size: (99, 9, 99))]"),
            "hint: of its points, 20 inside or too close to 'avoid'\n");
  EXPECT_EQ(hint(", where: height(from: 9m, to: 10m)"),
            "hint: of its points, 20 removed by 'where'\n");
  EXPECT_EQ(hint(", on: half_space(normal: (0, 0.1, 1)), from: 900m, spacing: 50m"),
            "hint: of its points, 19 closer than 'spacing' to another, 1 on ground steeper than "
            "'steepest'\n");
  EXPECT_EQ(warnings(square), "");
}

TEST(GrovePlaces, TooManyAreReportedWithTheirLocation) {
  const std::string said = warnings("polygon: [(0, 0), (9, 0), (9, 9)], density: 1e12");
  EXPECT_NE(said.find("t.vug:10:7: error: "), std::string::npos) << said;
  EXPECT_NE(said.find("exceed the limit of"), std::string::npos) << said;
}

TEST(GrovePlaces, FaultsAreReportedWithTheirLocation) {
  const std::string square = "polygon: [(0, 0), (9, 0), (9, 9), (0, 9)]";
  EXPECT_NE(grove_faults("polygon: [(0, 0), (2, 2), (2, 0), (0, 2)], density: 10")
                .find("t.vug:10:23: error: sides 1 and 3 of the polygon cross or touch at (1, 1)"),
            std::string::npos)
      << grove_faults("polygon: [(0, 0), (2, 2), (2, 0), (0, 2)], density: 10");
  EXPECT_NE(grove_faults("polygon: [(0, 0), (2, 2)], density: 10").find("3 corners"),
            std::string::npos);
  EXPECT_NE(grove_faults("polygon: [(0, 0), 3], density: 10").find("corner (x, z)"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", density: 10, count: 3").find("not both"), std::string::npos);
  EXPECT_NE(grove_faults(square + ", density: -1").find("at least 0"), std::string::npos);
  EXPECT_NE(grove_faults(square + ", density: 10, diameter: 5cm").find("diameters"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", density: 10, distribution: papre").find("distribution"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", distribution: paper(weights: [-1, 1])").find("at least 0"),
            std::string::npos);
  EXPECT_NE(
      grove_faults(square + ", distribution: paper(weights: [0, 0])").find("the smaller one first"),
      std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, diameter: 1cm, diameters: [1cm, 2cm]")
                .find("model number"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, diameter: 1cm, diameters: [1cm, 2cm]")
                .find("hint: models are counted from 0, in the order of 'of'"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, from: 3m").find("there is no ground 'on'"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, steepest: 20deg").find("there is no ground 'on'"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, margin: 3m").find("'avoid'"), std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, on: thick")
                .find("hint: 'thick' is declared by 'object' on 'large_mesh'"),
            std::string::npos);
  EXPECT_NE(grove_faults(square + ", count: 5, diameter_spread: 1cm")
                .find("'diameter', which is missing"),
            std::string::npos);
  // Only "as many as fit" needs no number.
  EXPECT_NE(
      grove_faults(square + ", distribution: thomas").find("'density' per hectare or a 'count'"),
      std::string::npos);
  EXPECT_NE(grove_faults(square).find("'density' per hectare or a 'count'"), std::string::npos);
  EXPECT_GT(cast("place p { of thin  at grove(" + square +
                 ", distribution: poisson_disk(distance: 1m)) }\n")
                .objects.size(),
            40u);
}

}  // namespace
}  // namespace vug::loading
