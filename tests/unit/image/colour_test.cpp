// SPDX-License-Identifier: Apache-2.0
// Working spaces and views. OpenColorIO's own transforms and published numbers serve as reference.
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/base/srgb.h>
#include <vug/image/brightness.h>
#include <vug/image/io.h>
#include <vug/image/ocio_view.h>
#include <vug/image/texture.h>

#include <OpenColorIO/OpenColorIO.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace vug::image {
namespace {
namespace ocio = OCIO_NAMESPACE;

TEST(Colour, TheMatrixOfAcescgIsThatOfOpenColorIO) {
  const ColourMatrix back(WorkingSpace::acescg, WorkingSpace::rec709);
  const auto builtin = ocio::BuiltinTransform::Create();
  builtin->setStyle("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD");
  const auto processor = ocio::Config::CreateRaw()->getProcessor(builtin)->getDefaultCPUProcessor();
  for (int c = 0; c < 3; ++c) {
    Vec3f unit(0.0f);
    unit[c] = 1;
    Vec3f theirs = unit;
    processor->applyRGB(&theirs.x);
    const Vec3f ours = back(unit);
    // The white of Rec.709 has four digits here and in the standard, more in OpenColorIO.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-4) << c << i;
  }
}

TEST(Colour, MatricesKeepWhiteAndUndoEachOther) {
  const ColourMatrix there(WorkingSpace::rec709, WorkingSpace::acescg);
  const ColourMatrix back(WorkingSpace::acescg, WorkingSpace::rec709);
  EXPECT_TRUE(ColourMatrix(WorkingSpace::acescg, WorkingSpace::acescg).is_identity());
  EXPECT_FALSE(there.is_identity());
  const Vec3d white = there(Vec3d(1.0));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1, 1e-12);
  const Vec3d colour(0.9, 0.1, 0.3), again = back(there(colour));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(again[i], colour[i], 1e-12);
  // No colour of Rec.709 is outside ACEScg.
  for (size_t row = 0; row < 3; ++row)
    for (size_t column = 0; column < 3; ++column) EXPECT_GT(there.at(row, column), 0);
}

Image pixel(const Vec3f& c) {
  Image image(1, 1, {"R", "G", "B"});
  image.pixels = {c.x, c.y, c.z};
  return image;
}

TEST(Colour, AViewDisplaysTheSameLightEquallyFromBothSpaces) {
  const Vec3f light(0.3f, 0.12f, 0.05f);
  const ColourMatrix there(WorkingSpace::rec709, WorkingSpace::acescg);
  for (const char* view : {"filmic", "standard", "aces"}) {
    const Image a = display(pixel(light), view_options({view, {}, {}}, WorkingSpace::rec709));
    const Image b =
        display(pixel(there(light)), view_options({view, {}, {}}, WorkingSpace::acescg));
    for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.pixels[i], b.pixels[i], 1e-4) << view;
    EXPECT_NEAR(*grey_exposure(pixel(light)),
                *grey_exposure(pixel(there(light)), WorkingSpace::acescg), 1e-5);
  }
}

TEST(Colour, TheAcesViewGivesThePublishedGrey) {
  // Middle grey of the tone scale: 0.18 of the scene maps to a tenth of the display's white, 4.8
  // nit of 48 in the cinema.
  const Image grey =
      display(pixel(Vec3f(0.18f)), view_options({"aces", {}, {}}, WorkingSpace::acescg));
  for (const float v : grey.pixels) EXPECT_NEAR(v, srgb_encode(0.1), 2.0 / 255);
  const Image white =
      display(pixel(Vec3f(100.0f)), view_options({"aces", {}, {}}, WorkingSpace::acescg));
  for (const float v : white.pixels) EXPECT_GT(v, 0.99f);
}

struct File {
  explicit File(const char* text) { std::ofstream(path) << text; }
  ScratchFolder scratch{"vug_colour"};
  std::filesystem::path path = scratch.file("config.ocio");
};

constexpr const char* kStudio = R"(ocio_profile_version: 2
roles: {scene_linear: lin, default: lin}
file_rules: [!<Rule> {name: Default, colorspace: lin}]
displays:
  Projector: [!<View> {name: Half, colorspace: half}, !<View> {name: Raw, colorspace: lin}]
active_displays: [Projector]
colorspaces:
  - !<ColorSpace> {name: lin, aliases: [lin_rec709_scene]}
  - !<ColorSpace>
    name: half
    from_scene_reference: !<CDLTransform> {slope: [0.5, 0.5, 0.25]}
)";

std::string told(const ViewSelection& choice, WorkingSpace space = WorkingSpace::rec709) {
  try {
    view_options(choice, space);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    return std::string(error.what()) + " | " + error.hint();
  }
  return "";
}

TEST(Colour, AConfigurationsViewsAreFoundByName) {
  const File studio(kStudio);
  const auto shown = [&](const char* view) {
    return display(pixel(Vec3f(0.5f)), view_options({view, {}, studio.path}, WorkingSpace::rec709));
  };
  EXPECT_NEAR(shown("").pixels[0], 0.25f, 1e-6);  // The default is the first.
  EXPECT_NEAR(shown("Half").pixels[2], 0.125f, 1e-6);
  EXPECT_NEAR(shown("Raw").pixels[2], 0.5f, 1e-6);
  EXPECT_EQ(shown("filmic"),
            display(pixel(Vec3f(0.5f))));  // Built-in views are available in addition.
  EXPECT_FALSE(view_options({"", {}, studio.path}, WorkingSpace::rec709).ocio->srgb());
}

TEST(Colour, UnknownNamesAreReportedWithTheKnownOnes) {
  const File studio(kStudio);
  EXPECT_NE(told({"acs", {}, {}}).find("aces"), std::string::npos);
  EXPECT_NE(told({"Hal", {}, studio.path}).find("Half, Raw, filmic, standard"), std::string::npos);
  EXPECT_NE(told({"Raw", "Screen", studio.path}).find("Projector"), std::string::npos);
  EXPECT_NE(told({"", {}, "/nowhere.ocio"}).find("/nowhere.ocio"), std::string::npos);
  // This configuration does not define ACEScg.
  const std::string space = told({"Raw", {}, studio.path}, WorkingSpace::acescg);
  EXPECT_NE(space.find("acescg"), std::string::npos);
  EXPECT_NE(space.find("lin_ap1_scene"), std::string::npos);
  const File garbage("no configuration");
  EXPECT_NE(told({"", {}, garbage.path}).find("cannot be used"), std::string::npos);
}

TEST(Colour, APictureOfOtherPrimariesIsATextureOfTheSameLight) {
  const ScratchFolder scratch("vug_colour");
  const std::filesystem::path path = scratch.file("picture.exr");
  const Vec3f light(0.6f, 0.25f, 0.1f);
  ExrOptions options;
  options.space = WorkingSpace::acescg;
  const Vec3f stored = ColourMatrix(WorkingSpace::rec709, WorkingSpace::acescg)(light);
  Image image(8, 8, {"R", "G", "B"});
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = stored[static_cast<int>(i % 3)];
  write_exr(path, image, options);
  const Vec3d seen = Texture(path).at(0.5, 0.5, 0.1);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], light[i], 1e-5);
  const FileInfo info = read_info(path);
  ASSERT_TRUE(info.chromaticities);
  EXPECT_NEAR((*info.chromaticities)[0], 0.713, 1e-6);
}

}  // namespace
}  // namespace vug::image
