// SPDX-License-Identifier: Apache-2.0
// Content of the text by plain search; tests/dcc reads it with third-party readers.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/exchange/program.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sample.h"

namespace vug::exchange {
namespace {

class Usda : public testing::Test {
 protected:
  std::string text_of(const Assembly& assembly, const Space& space = {},
                      const FormatOptions& options = {}) {
    written_ = write(format("usda"), assembly, space, folder_ / "a.usda", options);
    return read_text(folder_ / "a.usda");
  }
  const ScratchFolder scratch_{"vug_usda"};
  const std::filesystem::path& folder_ = scratch_.path();
  WriteReport written_;
};

size_t count(const std::string& text, const std::string& what) {
  size_t found = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// The numbers after the first "NAME = " behind `from`, without brackets, to the end of the line.
std::vector<double> numbers(const std::string& text, const std::string& name,
                            const std::string& from = "") {
  const size_t begin = text.find(from);
  const size_t at = text.find(" " + name + " = ", begin == std::string::npos ? 0 : begin);
  if (at == std::string::npos) return {};
  std::string line = text.substr(at + name.size() + 4);
  line = line.substr(0, std::min(line.find('\n'), line.find(" (inter")));
  std::replace_if(
      line.begin(), line.end(),
      [](char c) { return c == '(' || c == ')' || c == '[' || c == ']' || c == ','; }, ' ');
  std::istringstream in(line);
  std::vector<double> out;
  for (double value = 0; in >> value;) out.push_back(value);
  return out;
}

// The subsets are a partition of the triangles.
TEST_F(Usda, RockMaterialsAreSubsetsOfTheTriangles) {
  Assembly all = sample();
  all.prototypes[0].mesh = two_rocks(*all.prototypes[0].mesh);
  const mesh::Mesh& cube = *all.prototypes[0].mesh;
  const std::string text = text_of(all);
  EXPECT_EQ(count(text, "subsetFamily:materialBind:familyType = \"partition\""), 1u);
  EXPECT_EQ(count(text, "def GeomSubset \"rock_limestone\""), 1u);
  EXPECT_EQ(count(text, "def GeomSubset \"rock_shale\""), 1u);
  EXPECT_EQ(count(text, "no_rock"), 0u);
  EXPECT_EQ(count(text, "primvars:w_shale"), 1u);
  std::vector<double> faces = numbers(text, "indices", "rock_limestone");
  const std::vector<double> rest = numbers(text, "indices", "rock_shale");
  EXPECT_GE(faces.size(), 2u);  // The floor; a wall belongs to the rock of two of its corners.
  EXPECT_GE(rest.size(), 2u);
  faces.insert(faces.end(), rest.begin(), rest.end());
  std::sort(faces.begin(), faces.end());
  ASSERT_EQ(faces.size(), cube.triangles.size());
  for (size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(faces[i], static_cast<double>(i));
  EXPECT_EQ(count(text_of(sample()), "GeomSubset"), 0u);
}

TEST_F(Usda, EachRockHasItsMaterial) {
  Assembly all = sample();
  Prototype& cube = all.prototypes[0];
  cube.mesh = two_rocks(*cube.mesh);
  const auto binding = [](const std::string& text, const std::string& rock) {
    const size_t at =
        text.find("material:binding = <", text.find("GeomSubset \"rock_" + rock + "\""));
    return text.substr(at + 20, text.find('>', at) - at - 20);
  };
  const std::string shared = text_of(all);
  EXPECT_EQ(binding(shared, "limestone"), binding(shared, "shale"));
  cube.rocks = {{"limestone", cube.look}, {"shale", cube.look}};
  cube.rocks[1].look.roughness = 0.125;
  cube.rocks[1].look.ior = 1.75;
  const std::string text = text_of(all);
  for (const char* rock : {"limestone", "shale"}) {
    const std::string name = cube.material + "_" + rock;
    EXPECT_TRUE(binding(text, rock).ends_with("/materials/" + name)) << binding(text, rock);
    EXPECT_EQ(count(text, "def Material \"" + name + "\""), 1u);
  }
  EXPECT_EQ(numbers(text, "inputs:roughness", "_shale\"").at(0), 0.125);
  EXPECT_EQ(numbers(text, "inputs:roughness", "_limestone\"").at(0), cube.look.roughness);
  // A second mesh of the same looks shares the materials; one with other rocks does not.
  all.prototypes.push_back(cube);
  all.groups.push_back({"again", all.prototypes.size() - 1, {Transform()}});
  EXPECT_EQ(count(text_of(all), "def Material "), count(text, "def Material "));
  all.prototypes.back().rocks[0].look.roughness = 0.5;
  EXPECT_EQ(count(text_of(all), "def Material "), count(text, "def Material ") + 3);
}

TEST_F(Usda, ACubeOfAMetreIsOneMetreInEverySpace) {
  for (const double unit : {1.0, 0.01})
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
      const std::string text = text_of(sample(), {up, unit});
      EXPECT_EQ(numbers(text, "metersPerUnit"), std::vector<double>{unit});
      EXPECT_EQ(count(text, up == UpAxis::y ? "upAxis = \"Y\"" : "upAxis = \"Z\""), 1u);
      const std::vector<double> box = numbers(text, "extent");
      ASSERT_EQ(box.size(), 6u);
      for (size_t i = 0; i < 3; ++i) EXPECT_NEAR((box[i + 3] - box[i]) * unit, 1, 1e-6);
      // The camera is 1.5 m above the ground and sees 36 mm of film, in tenths of the unit.
      const std::vector<double> place = numbers(text, "xformOp:transform", "Camera \"main\"");
      ASSERT_EQ(place.size(), 16u);
      EXPECT_NEAR(place[up == UpAxis::y ? 13 : 14] * unit, 1.5, 1e-9);
      const double film = numbers(text, "horizontalAperture", "Camera \"main\"").at(0);
      const double focal = numbers(text, "focalLength", "Camera \"main\"").at(0);
      EXPECT_NEAR(film * unit / 10, 0.036, 1e-9);
      EXPECT_NEAR(film / (2 * focal), 1, 1e-9);  // the tangent of 45 degrees
      // f-number: focal length divided by the aperture of 1 cm.
      EXPECT_NEAR(numbers(text, "fStop", "Camera \"main\"").at(0), 0.018 / 0.01, 1e-9);
      EXPECT_NEAR(numbers(text, "inputs:radius", "SphereLight").at(0) * unit, 0.25, 1e-9);
    }
}

TEST_F(Usda, EverythingIsThereOnce) {
  Assembly all = sample();
  all.volumes.push_back(
      {"fog", "sample_fog.vdb", {{"density", "fog volume"}}, Box3d(Vec3d(0.0), Vec3d(1.0))});
  const std::string text = text_of(all);
  const std::pair<const char*, size_t> expected[] = {{"def Mesh ", 2},
                                                     {"def PointInstancer ", 1},
                                                     {"def Camera ", 2},
                                                     {"def SphereLight ", 2},
                                                     {"def RectLight ", 1},
                                                     {"def DiskLight ", 1},
                                                     {"def DistantLight ", 1},
                                                     {"def DomeLight ", 1},
                                                     {"def Volume ", 1},
                                                     {"def OpenVDBAsset ", 1},
                                                     {"def Material ", 1},
                                                     {"point3f[] points", 1},
                                                     {"color3f[] primvars:displayColor", 1},
                                                     {"float[] primvars:wetness", 1},
                                                     {"vector3f[] primvars:flow", 1},
                                                     {"prepend references", 1}};
  for (const auto& [what, times] : expected) EXPECT_EQ(count(text, what), times) << what;
  EXPECT_EQ(numbers(text, "positions").size(), 9u);
  EXPECT_EQ(count(text, "{"), count(text, "}"));
}

TEST_F(Usda, PartialOpacityIsExported) {
  Assembly all = sample();
  all.prototypes[0].look.opacity = 0.25;
  EXPECT_EQ(numbers(text_of(all), "inputs:opacity"), std::vector<double>{0.25});
  mesh::Mesh veiled = *all.prototypes[0].mesh;
  veiled.attributes.push_back({"opacity", 1, std::vector<float>(veiled.positions.size(), 0.5f)});
  all.prototypes[0].mesh = std::make_shared<const mesh::Mesh>(veiled);
  const std::string text = text_of(all);
  EXPECT_EQ(count(text, "float inputs:opacity.connect = <"), 1u);
  EXPECT_EQ(count(text, "inputs:opacity = "), 0u);
  EXPECT_EQ(count(text, "string inputs:varname = \"opacity\""), 1u);
}

TEST_F(Usda, LightsHaveTheirRadianceAndTheSunItsIrradiance) {
  const std::string text = text_of(sample());
  EXPECT_EQ(numbers(text, "inputs:intensity", "SphereLight"), std::vector<double>{4});
  EXPECT_EQ(numbers(text, "inputs:color", "SphereLight"), (std::vector<double>{1, 0.5, 0.25}));
  EXPECT_NEAR(numbers(text, "inputs:intensity", "DistantLight").at(0),
              4 * kPi * std::pow(std::sin(0.005), 2), 1e-12);
  EXPECT_NEAR(numbers(text, "inputs:shaping:cone:angle").at(0), 0.5 * 180 / kPi, 1e-9);
}

TEST_F(Usda, TheRecipeIsOneString) {
  const std::string text = text_of(sample());
  EXPECT_EQ(count(text, R"("seed 7\n# a \"recipe\"\n")"), 1u);
}

TEST_F(Usda, ATruncatedFileIsRefused) {
  const std::string text = text_of(sample());
  const Format& usda = format("usda");
  EXPECT_FALSE(usda.read_metadata(text, "a.usda").empty());
  const size_t recipe = text.find("# a ");
  for (const size_t left : {recipe, text.size() / 2, text.size() - 100, text.size() - 2})
    EXPECT_THROW(usda.read_metadata(text.substr(0, left), "a.usda"), Error) << left;
}

TEST_F(Usda, LevelsOfDetailAreVariants) {
  Assembly all = sample();
  all.prototypes[0].coarser.push_back({all.prototypes[0].mesh, 0.25});
  const std::string text = text_of(all, {UpAxis::y, 0.01});
  EXPECT_EQ(count(text, "variantSet \"levelOfDetail\""), 1u);
  EXPECT_EQ(count(text, "\"lod1\" {"), 1u);
  EXPECT_EQ(numbers(text, "vug:distance"), std::vector<double>{25});
}

TEST_F(Usda, AnEnvironmentMapIsASeparateFile) {
  Assembly all = sample();
  image::Image sky(4, 2, {"R", "G", "B"});
  all.lights.back().picture = std::make_shared<const image::Image>(sky);
  const std::string text = text_of(all);
  ASSERT_EQ(written_.files.size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(written_.files[1]));
  EXPECT_EQ(count(text, "@./a_lamp5.exr@"), 1u);
}

TEST_F(Usda, AnUnwritablePathIsReported) {
  std::filesystem::create_directories(folder_ / "b.usda");
  EXPECT_THROW(write(format("usda"), sample(), {}, folder_ / "b.usda"), Error);
  text_of(sample());
  const std::string before = read_text(folder_ / "a.usda");
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(write(format("usda"), sample(), {}, folder_ / "a.usda", {}, cancelled), Error);
  EXPECT_EQ(before, read_text(folder_ / "a.usda"));
}

TEST(Programs, NameExistingFormats) {
  for (const Program* each : programs()) {
    EXPECT_FALSE(each->formats.empty()) << each->info.name;
    for (const std::string& name : each->formats) EXPECT_NO_THROW(format(name));
    EXPECT_EQ(&program(each->info.name), each);
  }
  EXPECT_THROW(program("softimage"), Error);
  EXPECT_THROW(format("fbx"), Error);
}

TEST_F(Usda, VariantsShareTheirEqualParts) {
  const Assembly whole = sample();
  auto moved = std::make_shared<Assembly>(sample());
  moved->groups[0].places = {Transform::translation({5, 0, 0})};
  auto other = std::make_shared<Assembly>(sample());
  other->lights.pop_back();
  FormatOptions options;
  options.variants = {{"moved", moved}, {"no sky", other}};
  const std::string text = text_of(whole, {}, options);
  EXPECT_EQ(count(text, "prepend variantSets = \"variant\""), 1u);
  EXPECT_EQ(count(text, "variants = { string variant = \"default\" }"), 1u);
  const size_t set = text.find("variantSet \"variant\" = {");
  ASSERT_NE(set, std::string::npos);
  const std::string shared = text.substr(0, set), own = text.substr(set);
  EXPECT_EQ(count(shared, "def PointInstancer \"strewn\""), 1u);
  EXPECT_EQ(count(own, "def PointInstancer"), 0u);
  EXPECT_EQ(count(shared, "def Xform \"cube\""), 0u);
  EXPECT_EQ(count(own, "def Xform \"cube\""), 3u);
  EXPECT_EQ(count(own, "(5, 0, 0, 1)"), 1u);
  EXPECT_EQ(count(shared, "def DomeLight"), 0u);
  EXPECT_EQ(count(own, "def DomeLight"), 2u);
  for (const char* name : {"\"default\" {", "\"moved\" {", "\"no_sky\" {"})
    EXPECT_EQ(count(own, name), 1u) << name;
  EXPECT_EQ(count(text, "{"), count(text, "}"));
  EXPECT_EQ(count(text, "prepend references"), 0u);
}

TEST_F(Usda, OtherFormatsHaveNoVariants) {
  FormatOptions options;
  options.variants = {{"other", std::make_shared<const Assembly>(sample())}};
  try {
    write(format("glb"), sample(), {}, folder_ / "a.glb", options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "files of the format glb have no variants");
  }
}

}  // namespace
}  // namespace vug::exchange
