// SPDX-License-Identifier: Apache-2.0
// Reading of labelled pictures and its error messages.
#include "painted.h"

#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/labelling.h>
#include <vug/image/io.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace vug::fit {
namespace {

namespace fs = std::filesystem;

const Classes kClasses{{"door", "shop", "window", "stone", "sky"}};
const image::ViewOptions kData = image::plain_view();

/// The error message; "" without an error.
std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}
#define EXPECT_FAULT(work, part)                                   \
  EXPECT_NE(fault_of([&] { work; }).find(part), std::string::npos) \
      << "'" << fault_of([&] { work; }) << "'"

void write_pair(const fs::path& folder, const std::string& name, const PaintedFacade& facade) {
  fs::create_directories(folder / "images");
  fs::create_directories(folder / "labels");
  image::write_png(folder / "images" / (name + ".png"), facade.photo, kData);
  image::write_grey_png(folder / "labels" / (name + ".png"), facade.classes, facade.width(),
                        facade.height());
}

TEST(Classes, LabelsAreGreyPictures) {
  const ScratchFolder folder("labels");
  const fs::path file = folder.path() / "l.png";
  image::write_grey_png(file, {0, 1, 2, 128, 254, kUnlabelled}, 3, 2);
  EXPECT_EQ(image::read_info(file).channels.size(), 1U);
  const image::Image read = image::read(file);
  for (const auto& [i, value] : {std::pair<size_t, float>{1, 1}, {3, 128}, {4, 254}, {5, 255}})
    EXPECT_NEAR(255 * read.pixels[i], value, 1e-4);
  EXPECT_THROW(image::write_grey_png(file, {0, 1}, 3, 2), Error);
}

TEST(Classes, AreReadByNumberAndHaveRegionTypes) {
  const Classes found =
      classes_from_json(nlohmann::json::parse(R"({"1": "window", "0": "balcony", "2": "shop"})"));
  EXPECT_EQ(found.names, (std::vector<std::string>{"balcony", "window", "shop"}));
  EXPECT_EQ(found.region_type(0), RegionType::wall);
  EXPECT_EQ(found.region_type(1), RegionType::window);
  EXPECT_EQ(found.region_type(2), RegionType::shop);
  EXPECT_EQ(found.find(RegionType::shop), 2);
  EXPECT_EQ(found.find(RegionType::door), -1);
  EXPECT_EQ(classes_from_json(to_json(found)), found);
}

TEST(Classes, InvalidInputIsRejected) {
  const auto read = [](const char* text) { classes_from_json(nlohmann::json::parse(text)); };
  EXPECT_FAULT(read("[]"), "an object");
  EXPECT_FAULT(read("{}"), "an object");
  EXPECT_FAULT(read(R"({"0": "window", "2": "wall"})"), "1 is missing");
  EXPECT_FAULT(read(R"({"0": "window", "1": 7})"), "class 1 has no name");
  EXPECT_FAULT(read(R"({"0": "window", "1": "window"})"), "two classes");
  EXPECT_FAULT(read(R"({"0": "wall"})"), "no class is named 'window'");
  const ScratchFolder folder("vug_labels");
  write_text(folder.path() / "classes.json", "{\n\"0\": \"window\",\n}");
  try {
    read_classes(folder.path() / "classes.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().line, 3);
  }
  EXPECT_FAULT(read_classes(folder.path() / "none.json"), "none.json");
}

TEST(LabelledImage, FoldersAreReadInNaturalOrder) {
  const ScratchFolder folder("vug_labels");
  for (const char* name : {"facade_10", "facade_9", "facade_1"})
    write_pair(folder.path(), name, painted(1, 40, 60, 2, 2));
  const std::vector<LabelledImage> found = read_labelled_folder(folder.path(), kClasses);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "facade_1");
  EXPECT_EQ(found[1].name, "facade_9");
  EXPECT_EQ(found[2].name, "facade_10");
  const PaintedFacade facade = painted(1, 40, 60, 2, 2);
  EXPECT_EQ(found[0].labels, facade.classes);
  for (size_t i = 0; i < facade.photo.pixels.size(); ++i)
    EXPECT_NEAR(found[0].photo.pixels[i], std::clamp(facade.photo.pixels[i], 0.0f, 1.0f), 0.01);
}

TEST(LabelledImage, LargePicturesAreDownsampled) {
  const ScratchFolder folder("vug_labels");
  write_pair(folder.path(), "a", painted(1, 40, 60, 2, 2));
  const std::vector<LabelledImage> found =
      read_labelled_folder(folder.path(), kClasses, {.height = 30, .pixels = 10'000});
  EXPECT_EQ(found[0].photo.width, 20);
  EXPECT_EQ(found[0].labels.size(), 600U);
}

TEST(LabelledImage, MismatchesAreReported) {
  const PaintedFacade facade = painted(1, 40, 60, 2, 2);
  const ScratchFolder folder("vug_labels");
  const fs::path& root = folder.path();
  EXPECT_FAULT(read_labelled_folder(root, kClasses), "cannot read folder");
  fs::create_directories(root / "images");
  fs::create_directories(root / "labels");
  EXPECT_FAULT(read_labelled_folder(root, kClasses), "no pictures");
  write_pair(root, "a", facade);
  const fs::path photo = root / "images/a.png", labels = root / "labels/a.png";
  EXPECT_FAULT(read_labelled_image(photo, root / "labels/b.png", kClasses), "b.png");
  EXPECT_FAULT(read_labelled_image(photo, photo, kClasses), "colours instead");
  EXPECT_FAULT(read_labelled_image(photo, labels, Classes{{"window", "wall"}}),
               "has the unnamed class 4");
  EXPECT_FAULT(read_labelled_image(photo, labels, kClasses, {}, 1000), "more than the limit");
  image::write_grey_png(labels, std::vector<uint8_t>(39 * 60, kUnlabelled), 39, 60);
  EXPECT_FAULT(read_labelled_image(photo, labels, kClasses),
               "40 x 60 pixels, but its labels have 39 x 60");
  fs::remove(labels);
  EXPECT_FAULT(read_labelled_folder(root, kClasses), "has no labels");
  fs::rename(photo, root / "labels/c.png");
  EXPECT_FAULT(read_labelled_folder(root, kClasses), "no picture for the labels");
  write_pair(root, "a", facade);
  fs::remove(root / "labels/c.png");
  fs::copy_file(photo, root / "images/a.jpg");
  EXPECT_FAULT(read_labelled_folder(root, kClasses), "two files named a");
}

TEST(LabelledImage, OnePixel) {
  const ScratchFolder folder("vug_labels");
  image::write_png(folder.path() / "p.png", image::Image(1, 1, {"R", "G", "B"}), kData);
  image::write_grey_png(folder.path() / "l.png", {2}, 1, 1);
  const LabelledImage found =
      read_labelled_image(folder.path() / "p.png", folder.path() / "l.png", kClasses);
  EXPECT_EQ(found.labels, std::vector<uint8_t>{2});
}

}  // namespace
}  // namespace vug::fit
