// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/base/srgb.h>
#include <vug/image/io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <thread>

namespace vug::image {
namespace {
namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  fs::path file(const std::string& name) const { return folder_.file(name); }

 private:
  const ScratchFolder folder_{"vug_image"};
};

Image noisy_channels(int width, int height, std::vector<std::string> channels, double scale) {
  Image image(width, height, std::move(channels));
  RandomStream random(RandomKey(11).at("noise"));
  for (float& v : image.pixels) v = static_cast<float>(scale * random.normal());
  return image;
}

std::string message(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(Files, FullFloatsSurviveBitForBit) {
  Image image =
      noisy_channels(37, 23, {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "albedo.R"}, 1e3);
  image.at(3, 4, 4) = 1e10f;
  write_exr(file("a.exr"), image);
  const Image back = read(file("a.exr"));
  ASSERT_EQ(back.channels.size(), image.channels.size());
  EXPECT_EQ(back.select(image.channels).pixels, image.pixels);
}

TEST_F(Files, HalfRoundsByAtMostItsUnitAndKeepsDepthExact) {
  const Image image = noisy_channels(31, 17, {"R", "G", "B", "Z", "P.X"}, 10);
  ExrOptions options;
  options.half = true;
  write_exr(file("h.exr"), image, options);
  const Image back = read(file("h.exr")).select(image.channels);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    if (i % 5 >= 3)
      EXPECT_EQ(back.pixels[i], image.pixels[i]);
    else
      EXPECT_LE(std::fabs(back.pixels[i] - image.pixels[i]),
                std::fmax(std::fabs(image.pixels[i]) / 2048, 3e-8f));
  }
  const FileInfo info = read_info(file("h.exr"));
  ASSERT_EQ(info.channels.size(), info.formats.size());
  for (size_t c = 0; c < info.channels.size(); ++c)
    EXPECT_EQ(info.formats[c],
              info.channels[c].size() == 1 && info.channels[c] != "Z" ? "half" : "float")
        << info.channels[c];
}

TEST_F(Files, PartsAndTilesHoldTheSamePixels) {
  const Image image = noisy_channels(
      100, 70, {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "CryptoObject00.R"}, 10);
  for (const bool half : {false, true}) {
    ExrOptions options;
    options.half = half;
    options.full_channels.push_back("CryptoObject");
    options.metadata = {{"vug:seed", "7"}, {"cryptomatte/1234567/name", "CryptoObject"}};
    write_exr(file("plain.exr"), image, options);
    const Image plain = read(file("plain.exr")).select(image.channels);
    for (const bool tiles : {false, true})
      for (const bool parts : {false, true}) {
        options.tiles = tiles, options.parts = parts;
        write_exr(file("other.exr"), image, options);
        EXPECT_EQ(read(file("other.exr")).select(image.channels), plain) << tiles << parts;
        const FileInfo info = read_info(file("other.exr"));
        EXPECT_EQ(info.channels.size(), image.channels.size());
        for (const auto& entry : options.metadata)
          EXPECT_EQ(std::count(info.metadata.begin(), info.metadata.end(), entry), 1)
              << entry.first;
        for (size_t c = 0; c < info.channels.size(); ++c)
          if (info.channels[c] == "CryptoObject00.R") {
            EXPECT_EQ(info.formats[c], "float");
          }
      }
  }
}

TEST_F(Files, HalfClampsWhatItCannotHold) {
  Image image(2, 1, {"R"});
  image.pixels = {1e8f, -1e8f};
  ExrOptions options;
  options.half = true;
  write_exr(file("big.exr"), image, options);
  EXPECT_EQ(read(file("big.exr")).pixels, (std::vector<float>{65504.0f, -65504.0f}));
}

TEST_F(Files, SameContentGivesSameBytesAtAnyTime) {
  const Image image = noisy_channels(16, 16, {"R", "G", "B"}, 1);
  ExrOptions options;
  options.metadata = {{"vug:recipe", "seed 7"}, {"vug:version", "1"}};
  write_exr(file("1.exr"), image, options);
  write_png(file("1.png"), image, {}, options.metadata);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  write_exr(file("2.exr"), image, options);
  write_png(file("2.png"), image, {}, options.metadata);
  EXPECT_EQ(digest(read_text(file("1.exr"))), digest(read_text(file("2.exr"))));
  EXPECT_EQ(digest(read_text(file("1.png"))), digest(read_text(file("2.png"))));
}

TEST_F(Files, MetadataComesBack) {
  ExrOptions options;
  options.metadata = {{"vug:recipe", "param LD = 10"}, {"vug:seed", "2012"}};
  write_exr(file("m.exr"), Image(4, 4, {"R", "G", "B"}), options);
  const FileInfo info = read_info(file("m.exr"));
  for (const auto& entry : options.metadata)
    EXPECT_NE(std::find(info.metadata.begin(), info.metadata.end(), entry), info.metadata.end())
        << entry.first;
}

TEST_F(Files, PngHoldsTheDisplayValues) {
  const Image image = noisy_channels(29, 13, {"R", "G", "B"}, 0.5);
  const Image shown = display(image);
  write_png(file("p.png"), image);
  const Image back = read(file("p.png"));
  ASSERT_EQ(back.pixels.size(), shown.pixels.size());
  for (size_t i = 0; i < shown.pixels.size(); ++i)
    ASSERT_LE(std::fabs(back.pixels[i] - shown.pixels[i]), 1.0f / 255 + 1e-6f);
}

TEST_F(Files, PngStatesItsColourSpaceAndTexts) {
  const Image image(4, 3, {"R", "G", "B"});
  const std::string bytes = png_bytes(image, {}, {{"vug:pixel", "0.25"}});
  EXPECT_NE(bytes.find("sRGB"), bytes.npos);
  EXPECT_NE(bytes.find(std::string("tEXtvug:pixel\0"
                                   "0.25",
                                   18)),
            bytes.npos);
  write_grey_png(file("labels.png"), std::vector<uint8_t>(12, 7), 4, 3);
  EXPECT_EQ(read_text(file("labels.png")).find("sRGB"), std::string::npos);
  for (const float value : read_grey(file("labels.png")).pixels) EXPECT_FLOAT_EQ(value, 7.0f / 255);
}

TEST_F(Files, APlainViewKeepsEveryCode) {
  Image image(256, 9, {"Y"});  // More rows than the dither pattern has.
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(srgb_decode(static_cast<double>(i % 256) / 255));
  write_png(file("codes.png"), image, plain_view());
  const Image back = read_grey(file("codes.png"));
  for (size_t i = 0; i < image.pixels.size(); ++i)
    ASSERT_NEAR(back.pixels[i] * 255, static_cast<double>(i % 256), 1e-3);
}

TEST_F(Files, LinearReadingUndoesTheEncoding) {
  Image image(3, 1, {"R", "G", "B"});
  image.pixels = {0.1f, 0.2f, 0.4f, 0.5f, 0.6f, 0.7f, 0, 1, 0.9f};
  write_png(file("l.png"), image, plain_view());
  ReadOptions options;
  options.linear = true;
  const Image back = read(file("l.png"), options);
  for (size_t i = 0; i < image.pixels.size();
       ++i)  // Half a code step, with a slope of at most 2.2.
    EXPECT_NEAR(back.pixels[i], image.pixels[i], 2.3 / 510);
}

TEST_F(Files, GreyReadsOneOrThreeChannels) {
  Image grey(4, 3, {"Y"});
  for (size_t i = 0; i < grey.pixels.size(); ++i) grey.pixels[i] = static_cast<float>(i) / 16;
  write_exr(file("y.exr"), grey);
  EXPECT_EQ(read_grey(file("y.exr")).pixels, grey.pixels);
  Image colour(1, 1, {"R", "G", "B"});
  colour.pixels = {0.25f, 0.5f, 0.75f};
  write_exr(file("c.exr"), colour);
  EXPECT_FLOAT_EQ(read_grey(file("c.exr")).pixels[0], 0.5f);
}

TEST_F(Files, BrokenFilesAreReportedInSentences) {
  EXPECT_NE(message([&] { read(file("none.exr")); }).find("no such file"), std::string::npos);
  write_text(file("text.exr"), "this is not an image at all, and never was one");
  EXPECT_NE(message([&] { read(file("text.exr")); }).find("text.exr"), std::string::npos);
  write_text(file("empty.png"), "");
  EXPECT_NE(message([&] { read(file("empty.png")); }).find("empty.png"), std::string::npos);
  EXPECT_THROW(read(fs::temp_directory_path()), Error);

  write_exr(file("whole.exr"), noisy_channels(64, 64, {"R", "G", "B"}, 1));
  write_png(file("whole.png"), noisy_channels(64, 64, {"R", "G", "B"}, 1));
  for (const char* name : {"whole.exr", "whole.png"}) {
    const std::string whole = read_text(file(name));
    for (const size_t part : {size_t{3}, whole.size() / 8, whole.size() / 2, whole.size() - 40}) {
      const fs::path cut = file(std::string("cut_") + name);
      write_text(cut, whole.substr(0, part));
      EXPECT_THROW(read(cut), Error) << name << " cut at " << part;
    }
  }
}

TEST_F(Files, UnusableTargetsAreRefused) {
  const Image image(4, 4, {"R", "G", "B"});
  write_text(file("plain"), "a file, not a folder");
  EXPECT_THROW(write_exr(file("plain") / "a.exr", image), Error);
  EXPECT_THROW(write_exr(file("b.exr"), Image()), Error);
  EXPECT_THROW(write_png(file("b.png"), Image(2, 2, {"a", "b"})), Error);
  EXPECT_FALSE(fs::exists(file("b.exr")));
}

TEST(ImageStruct, RefusesInvalidArguments) {
  EXPECT_THROW(Image(0, 4, {"R"}), Error);
  EXPECT_THROW(Image(4, 4, {}), Error);
  EXPECT_THROW(Image(4, 4, {"R"}).select({"G"}), Error);
}

}  // namespace
}  // namespace vug::image
