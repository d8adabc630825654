// SPDX-License-Identifier: Apache-2.0
// Pixel classifiers trained on synthetic facades.
#include "painted.h"

#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/fit/learning/confusion.h>
#include <vug/fit/learning/labelling.h>
#include <vug/fit/learning/pixel_classifier.h>
#include <vug/fit/likelihood.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vug::fit {
namespace {

const Classes kRegionClasses{{"door", "shop", "window", "stone", "sky"}};
const PixelClassifierOptions kSmall{.first = {.trees = 6, .depth = 10},
                                    .second = {.trees = 6, .depth = 10, .tried_features = 20},
                                    .examples = 600};

std::vector<LabelledImage> noisy_facades(int count) {
  std::vector<LabelledImage> out;
  for (int i = 0; i < count; ++i) {
    PaintedFacade facade = painted(i, 80 + 4 * i, 120, 3 + i % 2, 3);
    out.push_back({std::to_string(i), std::move(facade.photo), std::move(facade.classes)});
  }
  return out;
}

PixelClassifier trained(const std::vector<LabelledImage>& pictures) {
  std::vector<const LabelledImage*> all;
  for (const LabelledImage& picture : pictures) all.push_back(&picture);
  return PixelClassifier::train(all, kRegionClasses, {}, kSmall, RandomKey(1));
}

TEST(PixelClassifier, GeneralisesToUnseenFacades) {
  ConfusionMatrix table(kRegionClasses.count());
  const std::vector<LabelledImage> pictures = noisy_facades(6);
  std::vector<int> seen(pictures.size(), 0);
  cross_validate(pictures, kRegionClasses, {.classifier = kSmall, .folds = 3}, RandomKey(1),
                 [&](size_t picture, const Planes& maps) {
                   ++seen[picture];
                   table.add(pictures[picture].labels, most_likely_classes(maps));
                 });
  EXPECT_EQ(seen, std::vector<int>(6, 1));
  EXPECT_GT(table.accuracy(), 0.95);
  EXPECT_GT(table.iou(kWindow), 0.85);
  EXPECT_THROW(cross_validate(pictures, kRegionClasses, {.folds = 1}, RandomKey(1), {}), Error);
  EXPECT_THROW(cross_validate(pictures, kRegionClasses, {.folds = 7}, RandomKey(1), {}), Error);
}

TEST(PixelClassifier, RoundTripPreservesTheModel) {
  const std::vector<LabelledImage> pictures = noisy_facades(2);
  const PixelClassifier model = trained(pictures);
  const ScratchFolder folder("vug_labels");
  write_text(folder.path() / "looks.json", model.to_json().dump());
  const PixelClassifier again = PixelClassifier::read(folder.path() / "looks.json");
  EXPECT_EQ(again.to_json(), model.to_json());
  EXPECT_EQ(again.classify(pictures[0].photo).planes, model.classify(pictures[0].photo).planes);
}

TEST(PixelClassifier, TrainingDoesNotDependOnThreads) {
  const std::vector<LabelledImage> pictures = noisy_facades(3);
  std::string first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const std::string text = trained(pictures).to_json().dump();
      if (threads == 1) first = text;
      EXPECT_EQ(text, first);
    });
  }
}

TEST(PixelClassifier, DamagedFilesAreRejected) {
  const nlohmann::json whole = trained(noisy_facades(1)).to_json();
  const auto refused = [&](const char* part, const nlohmann::json& value) {
    nlohmann::json text = whole;
    text[nlohmann::json::json_pointer(part)] = value;
    EXPECT_THROW(PixelClassifier::from_json(text), Error) << part;
  };
  EXPECT_NO_THROW(PixelClassifier::from_json(whole));
  refused("/format", "other");
  refused("/version", 2);
  refused("/classes", {{"0", "window"}});
  refused("/working/height", 0);
  refused("/working/pixels", "many");
  refused("/first", whole["second"]);
  refused("/second", nullptr);
  EXPECT_THROW(PixelClassifier::from_json(nlohmann::json::array()), Error);
  EXPECT_THROW(PixelClassifier::read("no/such/looks.json"), Error);
}

TEST(PixelClassifier, TinyPlainAndUnlabelledPictures) {
  LabelledImage pixel{"pixel", image::Image(1, 1, {"R", "G", "B"}), {kWindow}};
  const PixelClassifier model = trained({pixel});
  EXPECT_EQ(most_likely_classes(model.classify(pixel.photo)), std::vector<uint8_t>{kWindow});
  // Large pictures are classified at their working size.
  const Planes maps = model.classify(image::Image(30, 720, {"R", "G", "B"}));
  EXPECT_EQ(maps.height, 360);
  EXPECT_EQ(maps.width, 15);
  pixel.labels = {kUnlabelled};
  EXPECT_THROW(trained({pixel}), Error);
  EXPECT_THROW(trained({}), Error);
  const std::vector<LabelledImage> pictures = noisy_facades(1);
  PixelClassifierOptions options = kSmall;
  options.max_memory = 100'000;
  EXPECT_THROW(PixelClassifier::train({&pictures[0]}, kRegionClasses, {}, options, RandomKey(1)),
               Error);
}

TEST(ClassifierEvidence, BitsOfEachRegionType) {
  // A quarter door, a quarter window, the rest stone or sky.
  const Planes maps{1, 1, {{0.25f}, {0}, {0.25f}, {0.25f}, {0.25f}}};
  const auto bits = [&](RegionType type, const ClassifierEvidenceOptions& options) {
    const Sums sums = classifier_evidence(maps, kRegionClasses, options).sums(0, 0, 1, 1);
    return sums.lane[static_cast<size_t>(type)] * kBitStep;
  };
  const ClassifierEvidenceOptions plain{.windows = 1, .unnamed = 0, .min_probability = 1.0 / 64};
  EXPECT_EQ(bits(RegionType::wall, plain), 1);
  EXPECT_EQ(bits(RegionType::window, plain), 2);
  EXPECT_EQ(bits(RegionType::door, plain), 2);
  EXPECT_EQ(bits(RegionType::shop, plain), 6) << "the least";
  // Windows three times as likely: 0.5, 0.75 and 0.25 of 1.5.
  EXPECT_EQ(bits(RegionType::window, {.windows = 3, .unnamed = 0}), 1);
  // All of the door may be wall: 0.75 of 1.25.
  EXPECT_NEAR(bits(RegionType::wall, {.windows = 1, .unnamed = 1}), std::log2(1.25 / 0.75),
              kBitStep);
  EXPECT_THROW(classifier_evidence(maps, Classes{{"window"}}), Error);
}

TEST(Labelling, TreesDecideUncertainPixels) {
  const Classes classes{{"wall", "window", "balcony", "door"}};
  // Four pixels: certainly wall, maybe a window, maybe wall, maybe a balcony.
  const Planes maps{4,
                    1,
                    {{0.9f, 0.4f, 0.5f, 0.2f},
                     {0.1f, 0.5f, 0.4f, 0.3f},
                     {0.0f, 0.0f, 0.0f, 0.5f},
                     {0.0f, 0.1f, 0.1f, 0.0f}}};
  EXPECT_EQ(most_likely_classes(maps), (std::vector<uint8_t>{0, 1, 0, 2}));
  EXPECT_EQ(label_pixels(maps, classes, {}), (std::vector<uint8_t>{0, 0, 0, 2}))
      << "no window there";
  const std::vector<DetectedElement> window = {{RegionType::window, 0, {-3, -1, 9, 2}}};
  EXPECT_EQ(label_pixels(maps, classes, window), (std::vector<uint8_t>{0, 1, 1, 1}));
  EXPECT_EQ(label_pixels(maps, classes, window, {.tree_bias = 0}), most_likely_classes(maps));
  EXPECT_EQ(label_pixels(maps, classes, {{RegionType::door, 0, {0, 0, 4, 1}}}, {.tree_bias = 9}),
            (std::vector<uint8_t>{0, 3, 3, 2}));
  EXPECT_THROW(label_pixels(maps, Classes{{"window"}}, {}), Error);
}

TEST(Labelling, LaterElementsOverwriteEarlierOnes) {
  EXPECT_EQ(region_map({{RegionType::window, 0, {0, 0, 3, 1}}, {RegionType::door, 1, {1, 0, 2, 9}}},
                       4, 1),
            (std::vector<uint8_t>{1, 2, 1, 0}));
}

TEST(Maps, Enlarged) {
  const Planes maps{2, 1, {{0, 1}}};
  EXPECT_EQ(enlarged(maps, 4, 1).planes[0], (std::vector<float>{0, 0.25f, 0.75f, 1}));
  EXPECT_EQ(enlarged(maps, 2, 1).planes, maps.planes);
  EXPECT_EQ(enlarged(maps, 1, 3).planes[0], (std::vector<float>{0.5f, 0.5f, 0.5f}));
}

TEST(ConfusionMatrix, Figures) {
  ConfusionMatrix table(3);
  table.add({0, 0, 0, 1, 1, kUnlabelled}, {0, 0, 1, 1, 0, 2});
  EXPECT_EQ(table.count(0, 1), 1);
  EXPECT_EQ(table.class_count(0), 3);
  EXPECT_DOUBLE_EQ(table.accuracy(), 3.0 / 5);
  EXPECT_DOUBLE_EQ(table.class_average(), (2.0 / 3 + 1.0 / 2) / 2) << "of two classes";
  EXPECT_DOUBLE_EQ(table.iou(0), 2.0 / 4);
  EXPECT_DOUBLE_EQ(table.iou(2), 0);
  EXPECT_DOUBLE_EQ(ConfusionMatrix(2).accuracy(), 0);
  const std::string text = table.table(Classes{{"door", "window", "wall"}});
  EXPECT_NE(text.find("66.7"), std::string::npos) << text;
}

}  // namespace
}  // namespace vug::fit
