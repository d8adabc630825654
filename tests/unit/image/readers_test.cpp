// SPDX-License-Identifier: Apache-2.0
// Our readers of plain EXR and PNG files return what OpenImageIO returns, and leave other files to
// it.
#include <vug/base/atomic_file.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/backend.h>
#include <vug/image/deep.h>
#include <vug/image/exr/read.h>
#include <vug/image/png_reader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace vug::image {
namespace {

class Readers : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

 private:
  ScratchFolder folder_{"vug_readers_test"};
};

Image random_image(int width, int height, const std::vector<std::string>& channels) {
  Image image(width, height, channels);
  RandomStream random(RandomKey(3).at("readers"));
  for (float& value : image.pixels) value = static_cast<float>(random.uniform(-2, 2));
  return image;
}

const std::vector<std::string> kChannels = {
    "R",   "G",   "B",       "A",           "Z",          "samples",    "N.X",        "N.Y",
    "N.Z", "a.B", "a.b.R",   "a.b.alpha",   "Crypto00.R", "Crypto00.A", "Crypto01.G", "id",
    "u.V", "u.U", "depth.Z", "depth.ZBack", "p.Z",        "p.Y",        "p.A",        "q.x",
    "q.z", "q.a", "v.X",     "v.A",         "w.real",     "w.imag",     "w.Y"};

void expect_like_oiio(const std::filesystem::path& path, const std::optional<Image>& image,
                      const std::optional<FileInfo>& info) {
  ASSERT_TRUE(image && info) << path;
  const Image other = backend().read(path).image;
  EXPECT_EQ(image->channels, other.channels) << path;
  EXPECT_EQ(image->width, other.width);
  EXPECT_EQ(image->pixels, other.pixels) << path;
  const FileInfo theirs = backend().read_info(path);
  EXPECT_EQ(std::tie(info->width, info->height, info->left, info->top),
            std::tie(theirs.width, theirs.height, theirs.left, theirs.top));
  EXPECT_EQ(info->channels, theirs.channels);
  EXPECT_EQ(info->formats, theirs.formats);
  EXPECT_EQ(info->chromaticities, theirs.chromaticities);
  for (const auto& entry : info->metadata) {
    if (entry.first.rfind("vug:", 0) != 0) continue;  // OpenImageIO renames some standard texts.
    EXPECT_NE(std::find(theirs.metadata.begin(), theirs.metadata.end(), entry),
              theirs.metadata.end())
        << entry.first;
  }
}

TEST_F(Readers, ExrFilesAreReadAsByOpenImageIO) {
  const Image image = random_image(70, 67, kChannels);
  const Image other = random_image(70, 67, {"R", "G", "B"});
  ExrOptions options;
  options.metadata = {{"vug:seed", "7"}, {"vug:text", "two\nlines"}};
  for (const bool half : {false, true})
    for (const bool parts : {false, true})
      for (const bool tiles : {false, true}) {
        options.half = half, options.parts = parts, options.tiles = tiles;
        options.window = half ? ExrOptions::Window{5, 9, 200, 100} : ExrOptions::Window{};
        options.space = tiles ? WorkingSpace::acescg : WorkingSpace::rec709;
        write_exr(file("one.exr"), image, options);
        write_exr(file("two.exr"), {{"left", image, options}, {"right", other, options}});
        for (const char* name : {"one.exr", "two.exr"})
          expect_like_oiio(file(name), exr::read_flat(file(name)), exr::read_flat_info(file(name)));
      }
}

TEST_F(Readers, PngFilesAreReadAsByOpenImageIO) {
  write_png(file("colour.png"), random_image(33, 17, {"R", "G", "B"}), {}, {{"vug:pixel", "0.1"}});
  std::vector<uint8_t> codes(256);
  for (size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<uint8_t>(i);
  write_grey_png(file("grey.png"), codes, 32, 8);
  for (const char* name : {"colour.png", "grey.png"})
    expect_like_oiio(file(name), read_plain_png(file(name)), read_plain_png_info(file(name)));
}

TEST_F(Readers, DeepFilesAndOtherFormatsAreLeftToOpenImageIO) {
  DeepImage deep(2, 2);
  deep.at(0, 0).push_back({1, 2, 0.5f, 0.1f, 0.2f, 0.3f});
  write_deep_exr(file("deep.exr"), deep);
  write_text(file("text.exr"), "no picture");
  write_text(file("text.png"), "no picture");
  write_exr(file("exr.tif"), random_image(2, 2, {"Y"}));
  for (const char* name : {"deep.exr", "text.exr", "text.png", "exr.tif"}) {
    EXPECT_FALSE(exr::read_flat(file(name))) << name;
    EXPECT_FALSE(read_plain_png_info(file(name))) << name;
  }
}

}  // namespace
}  // namespace vug::image
