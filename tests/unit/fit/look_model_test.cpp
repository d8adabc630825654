// Looks that are trained on painted facades.
#include "painted.h"

#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/fit/learning/confusion.h>
#include <vug/fit/learning/labelling.h>
#include <vug/fit/likelihood.h>
#include <vug/fit/learning/pixel_classifier.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vug::fit {
namespace {

const Classes kClasses{{"door", "shop", "window", "stone", "sky"}};
const LookOptions kSmall{.first = {.trees = 6, .depth = 10},
                         .second = {.trees = 6, .depth = 10, .tried_features = 20},
                         .examples = 600};

std::vector<Labelled> facades(int count) {
  std::vector<Labelled> out;
  for (int i = 0; i < count; ++i) {
    PaintedFacade facade = painted(i, 80 + 4 * i, 120, 3 + i % 2, 3);
    out.push_back({std::to_string(i), std::move(facade.photo), std::move(facade.classes)});
  }
  return out;
}

LookModel trained(const std::vector<Labelled>& pictures) {
  std::vector<const Labelled*> all;
  for (const Labelled& picture : pictures) all.push_back(&picture);
  return LookModel::train(all, kClasses, {}, kSmall, RandomKey(1));
}

TEST(LookModel, KnowsFacadesThatItHasNotSeen) {
  Confusion table(kClasses.count());
  const std::vector<Labelled> pictures = facades(6);
  std::vector<int> seen(pictures.size(), 0);
  cross_validate(pictures, kClasses, {}, kSmall, 3, RandomKey(1),
                 [&](size_t picture, const Planes& maps) {
                   ++seen[picture];
                   table.add(pictures[picture].labels, most_likely(maps));
                 });
  EXPECT_EQ(seen, std::vector<int>(6, 1));
  EXPECT_GT(table.accuracy(), 0.95);
  EXPECT_GT(table.overlap(kWindow), 0.85);
  EXPECT_THROW(cross_validate(pictures, kClasses, {}, kSmall, 1, RandomKey(1), {}), Error);
  EXPECT_THROW(cross_validate(pictures, kClasses, {}, kSmall, 7, RandomKey(1), {}), Error);
}

TEST(LookModel, IsReadAsItIsWritten) {
  const std::vector<Labelled> pictures = facades(2);
  const LookModel model = trained(pictures);
  const ScratchFolder folder("vug_labels");
  write_text(folder.path() / "looks.json", model.to_json().dump());
  const LookModel again = LookModel::read(folder.path() / "looks.json");
  EXPECT_EQ(again.to_json(), model.to_json());
  EXPECT_EQ(again.classify(pictures[0].photo).planes, model.classify(pictures[0].photo).planes);
}

TEST(LookModel, AnyNumberOfThreadsTrainsTheSame) {
  const std::vector<Labelled> pictures = facades(3);
  std::string first;
  for (const int threads : {1, 2, 7}) {
    const ThreadLimit limit(threads);
    const std::string text = trained(pictures).to_json().dump();
    if (threads == 1) first = text;
    EXPECT_EQ(text, first);
  }
}

TEST(LookModel, DamagedFilesAreRefused) {
  const nlohmann::json whole = trained(facades(1)).to_json();
  const auto refused = [&](const char* part, const nlohmann::json& value) {
    nlohmann::json text = whole;
    text[nlohmann::json::json_pointer(part)] = value;
    EXPECT_THROW(LookModel::from_json(text), Error) << part;
  };
  EXPECT_NO_THROW(LookModel::from_json(whole));
  refused("/format", "other");
  refused("/version", 2);
  refused("/classes", {{"0", "window"}});
  refused("/working/height", 0);
  refused("/working/pixels", "many");
  refused("/first", whole["second"]);
  refused("/second", nullptr);
  EXPECT_THROW(LookModel::from_json(nlohmann::json::array()), Error);
  EXPECT_THROW(LookModel::read("no/such/looks.json"), Error);
}

TEST(LookModel, TinyPlainAndUnlabelledPictures) {
  Labelled pixel{"pixel", image::Image(1, 1, {"R", "G", "B"}), {kWindow}};
  const LookModel model = trained({pixel});
  EXPECT_EQ(most_likely(model.classify(pixel.photo)), std::vector<uint8_t>{kWindow});
  // Large ones are looked at in their working size.
  const Planes maps = model.classify(image::Image(30, 720, {"R", "G", "B"}));
  EXPECT_EQ(maps.height, 360);
  EXPECT_EQ(maps.width, 15);
  pixel.labels = {kVoid};
  EXPECT_THROW(trained({pixel}), Error);
  EXPECT_THROW(trained({}), Error);
  const std::vector<Labelled> pictures = facades(1);
  LookOptions options = kSmall;
  options.max_memory = 100'000;
  EXPECT_THROW(LookModel::train({&pictures[0]}, kClasses, {}, options, RandomKey(1)), Error);
}

TEST(LookEvidence, BitsOfEachLook) {
  // A quarter door, a quarter window, the rest stone or sky.
  const Planes maps{1, 1, {{0.25f}, {0}, {0.25f}, {0.25f}, {0.25f}}};
  const auto bits = [&](Look look, const LookEvidenceOptions& options) {
    const Sums sums = look_evidence(maps, kClasses, options).sums(0, 0, 1, 1);
    return sums.lane[static_cast<size_t>(look)] * kBitStep;
  };
  const LookEvidenceOptions plain{.windows = 1, .unnamed = 0, .least = 1.0 / 64};
  EXPECT_EQ(bits(Look::wall, plain), 1);
  EXPECT_EQ(bits(Look::window, plain), 2);
  EXPECT_EQ(bits(Look::door, plain), 2);
  EXPECT_EQ(bits(Look::shop, plain), 6) << "the least";
  // Windows thrice as likely: 0.5, 0.75 and 0.25 of 1.5.
  EXPECT_EQ(bits(Look::window, {.windows = 3, .unnamed = 0}), 1);
  // All of the door may be wall: 0.75 of 1.25.
  EXPECT_NEAR(bits(Look::wall, {.windows = 1, .unnamed = 1}), std::log2(1.25 / 0.75), kBitStep);
  EXPECT_THROW(look_evidence(maps, Classes{{"window"}}), Error);
}

TEST(Labelling, TreesTipTheBalance) {
  const Classes classes{{"wall", "window", "balcony", "door"}};
  // Four pixels: surely wall, perhaps a window, perhaps wall, perhaps a balcony.
  const Planes maps{4,
                    1,
                    {{0.9f, 0.4f, 0.5f, 0.2f},
                     {0.1f, 0.5f, 0.4f, 0.3f},
                     {0.0f, 0.0f, 0.0f, 0.5f},
                     {0.0f, 0.1f, 0.1f, 0.0f}}};
  EXPECT_EQ(most_likely(maps), (std::vector<uint8_t>{0, 1, 0, 2}));
  EXPECT_EQ(labels(maps, classes, {}), (std::vector<uint8_t>{0, 0, 0, 2})) << "no window there";
  const std::vector<Seen> window = {{Look::window, 0, {-3, -1, 9, 2}}};
  EXPECT_EQ(labels(maps, classes, window), (std::vector<uint8_t>{0, 1, 1, 1}));
  EXPECT_EQ(labels(maps, classes, window, {.trust = 0}), most_likely(maps));
  EXPECT_EQ(labels(maps, classes, {{Look::door, 0, {0, 0, 4, 1}}}, {.trust = 9}),
            (std::vector<uint8_t>{0, 3, 3, 2}));
  EXPECT_THROW(labels(maps, Classes{{"window"}}, {}), Error);
}

TEST(Labelling, LaterPartsCoverEarlierOnes) {
  EXPECT_EQ(looks_of({{Look::window, 0, {0, 0, 3, 1}}, {Look::door, 1, {1, 0, 2, 9}}}, 4, 1),
            (std::vector<uint8_t>{1, 2, 1, 0}));
}

TEST(Maps, Enlarged) {
  const Planes maps{2, 1, {{0, 1}}};
  EXPECT_EQ(enlarged(maps, 4, 1).planes[0], (std::vector<float>{0, 0.25f, 0.75f, 1}));
  EXPECT_EQ(enlarged(maps, 2, 1).planes, maps.planes);
  EXPECT_EQ(enlarged(maps, 1, 3).planes[0], (std::vector<float>{0.5f, 0.5f, 0.5f}));
}

TEST(Confusion, Figures) {
  Confusion table(3);
  table.add({0, 0, 0, 1, 1, kVoid}, {0, 0, 1, 1, 0, 2});
  EXPECT_EQ(table.count(0, 1), 1);
  EXPECT_EQ(table.of_class(0), 3);
  EXPECT_DOUBLE_EQ(table.accuracy(), 3.0 / 5);
  EXPECT_DOUBLE_EQ(table.class_average(), (2.0 / 3 + 1.0 / 2) / 2) << "of two classes";
  EXPECT_DOUBLE_EQ(table.overlap(0), 2.0 / 4);
  EXPECT_DOUBLE_EQ(table.overlap(2), 0);
  EXPECT_DOUBLE_EQ(Confusion(2).accuracy(), 0);
  const std::string text = table.table(Classes{{"door", "window", "wall"}});
  EXPECT_NE(text.find("66.7"), std::string::npos) << text;
}

}  // namespace
}  // namespace vug::fit
