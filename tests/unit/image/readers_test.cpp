// SPDX-License-Identifier: Apache-2.0
// Files that OpenEXR and libpng read, and those that are left to OpenImageIO.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/deep.h>
#include <vug/image/deep_info.h>
#include <vug/image/io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

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

/// In the order of OpenImageIO 2.4 (its channel list by `oiiotool --info`).
const std::vector<std::string> kOrder = {
    "R",          "G",           "B",   "A",   "Z",   "id",     "samples", "Crypto00.R",
    "Crypto00.A", "Crypto01.G",  "N.X", "N.Y", "N.Z", "a.B",    "a.b.R",   "a.b.alpha",
    "depth.Z",    "depth.ZBack", "p.Y", "p.A", "p.Z", "q.x",    "q.z",     "q.a",
    "u.U",        "u.V",         "v.A", "v.X", "w.Y", "w.real", "w.imag"};

TEST_F(Readers, ChannelsAreInTheOrderOfOpenImageIO) {
  std::vector<std::string> shuffled = kOrder;
  std::sort(shuffled.rbegin(), shuffled.rend());
  const Image image = random_image(9, 7, shuffled);
  write_exr(file("many.exr"), image);
  const Image back = read(file("many.exr"));
  EXPECT_EQ(back.channels, kOrder);
  for (size_t c = 0; c < kOrder.size(); ++c) {
    const auto from = static_cast<size_t>(std::find(shuffled.begin(), shuffled.end(), kOrder[c]) -
                                          shuffled.begin());
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 9; ++x) ASSERT_EQ(back.at(x, y, c), image.at(x, y, from)) << kOrder[c];
  }
}

TEST_F(Readers, PartsTilesAndViewsAreJoined) {
  const Image left = random_image(70, 67, {"R", "G", "B", "Z", "N.X", "N.Y", "N.Z"});
  const Image right = random_image(70, 67, {"R", "G", "B"});
  ExrOptions options;
  options.window = {5, 9, 200, 100};
  options.space = WorkingSpace::acescg;
  options.metadata = {{"vug:seed", "7"}, {"vug:text", "two\nlines"}};
  for (const bool tiles : {false, true}) {
    options.parts = options.tiles = tiles;
    write_exr(file("two.exr"), {{"left", left, options}, {"right", right, options}});
    const Image back = read(file("two.exr"));
    const std::vector<std::string> channels = {"R",   "G",   "B",       "Z",       "N.X",
                                               "N.Y", "N.Z", "right.R", "right.G", "right.B"};
    EXPECT_EQ(back.channels, channels);
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(back.at(69, 66, c), left.at(69, 66, c));
      EXPECT_EQ(back.at(69, 66, 7 + c), right.at(69, 66, c));
    }
    const FileInfo info = read_info(file("two.exr"));
    EXPECT_EQ(info.channels, channels);
    EXPECT_EQ(info.formats, std::vector<std::string>(10, "float"));
    EXPECT_EQ(std::make_pair(info.left, info.top), std::make_pair(5, 9));
    EXPECT_FALSE(to_rec709(info).is_identity());
    const std::map<std::string, std::string> texts(info.metadata.begin(), info.metadata.end());
    EXPECT_EQ(texts.at("vug:text"), "two\nlines");
  }
}

TEST_F(Readers, DeepFilesAreLeftToOpenImageIO) {
  DeepImage deep(2, 2);
  deep.at(0, 0).push_back({1, 2, 0.5f, 0.1f, 0.2f, 0.3f});
  write_deep_exr(file("deep.exr"), deep);
  EXPECT_EQ(read_deep_info(file("deep.exr")).value().samples, 1u);
  EXPECT_THROW(read(file("deep.exr")), Error);
  write_exr(file("flat.exr"), random_image(2, 2, {"Y"}));
  EXPECT_FALSE(read_deep_info(file("flat.exr")));
}

TEST_F(Readers, AnAttributeWithTheSizeOfAnotherTypeIsDamage) {
  write_exr(file("whole.exr"), random_image(2, 2, {"Y"}));
  std::string bytes = read_text(file("whole.exr"));
  const std::string ratio("pixelAspectRatio\0float\0", 23);
  const size_t at = bytes.find(ratio);
  ASSERT_NE(at, bytes.npos);
  bytes[at + ratio.size()] = 33;
  write_text(file("damaged.exr"), bytes);
  try {
    read_info(file("damaged.exr"));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("its header is damaged"), std::string::npos);
  }
}

}  // namespace
}  // namespace vug::image
