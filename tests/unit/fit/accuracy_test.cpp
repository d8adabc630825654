// SPDX-License-Identifier: Apache-2.0
// Accuracy of trees and pixel classifiers on photographed facades with labelled pixels; see
// docs/explanation/theory/facades.md. Uses a part of the pictures unless VUG_ACCURACY=all is set.
#include "../scan/external_data.h"

#include <vug/base/rng.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/learning/confusion.h>
#include <vug/fit/learning/labelling.h>
#include <vug/fit/model/compile.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

namespace vug::fit {
namespace {

const Classes kClasses{{"door", "shop", "balcony", "window", "wall", "sky", "roof"}};
constexpr uint8_t kWindow = 3;

bool all_asked_for() {
  const char* told = std::getenv("VUG_ACCURACY");
  return told && std::string(told) == "all";
}

/// Read once for all tests; every fifth picture unless all are requested.
const std::vector<LabelledImage>& facades() {
  static const std::vector<LabelledImage> found = [] {
    const std::filesystem::path folder = external_data();
    if (folder.empty() || !std::filesystem::is_directory(folder / "facades/labels"))
      return std::vector<LabelledImage>{};
    std::vector<LabelledImage> read = read_labelled_folder(folder / "facades", kClasses);
    if (all_asked_for()) return read;
    std::vector<LabelledImage> some;
    for (size_t i = 0; i < read.size(); i += 5) some.push_back(std::move(read[i]));
    return some;
  }();
  return found;
}

/// Accumulates the intersection and the union of true and detected window pixels.
class Windows {
 public:
  void add(const LabelledImage& truth, const std::vector<DetectedElement>& seen) {
    const std::vector<uint8_t> looks = region_map(seen, truth.photo.width, truth.photo.height);
    double both = 0, any = 0;
    for (size_t i = 0; i < looks.size(); ++i) {
      if (truth.labels[i] == kUnlabelled) continue;
      const bool found = static_cast<RegionType>(looks[i]) == RegionType::window;
      const bool there = truth.labels[i] == kWindow;
      both += found && there ? 1 : 0;
      any += found || there ? 1 : 0;
    }
    if (any > 0) each_ += both / any, count_ += 1;
    both_ += both, any_ += any;
    if (std::getenv("VUG_VERBOSE")) std::printf("  %-10s %.3f\n", truth.name.c_str(), both / any);
  }
  double overlap() const { return both_ / any_; }
  double mean_overlap() const { return each_ / count_; }

 private:
  double both_ = 0, any_ = 0, each_ = 0, count_ = 0;
};

class Accuracy : public testing::Test {
 protected:
  void SetUp() override {
    if (facades().empty())
      GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with facades/images and facades/labels";
  }
  /// Small pictures have only a few pixels per window.
  static FitOptions options(const char* likelihood) {
    FitOptions out;
    out.likelihood = likelihood;
    out.limits.min_size = 3;
    out.sampler.steps = 50'000;
    return out;
  }
  const Rules rules_ = compile(facade::load_rules(std::string(VUG_DATA) + "/facades/ripperda.vug"));
};

TEST_F(Accuracy, TrainedClassifier) {
  PixelClassifierOptions looks;
  if (!all_asked_for()) looks.first.trees = looks.second.trees = 8;
  ConfusionMatrix maps_alone(kClasses.count()), with_tree(kClasses.count());
  Windows windows;
  cross_validate(facades(), kClasses, {.classifier = looks, .folds = 5}, RandomKey(1),
                 [&](size_t k, const Planes& maps) {
                   const LabelledImage& truth = facades()[k];
                   const FitResult reading = fit_facade(classifier_evidence(maps, kClasses), rules_,
                                                        options("supervised"), RandomKey(1));
                   maps_alone.add(truth.labels, most_likely_classes(maps));
                   with_tree.add(truth.labels, label_pixels(maps, kClasses, reading.elements));
                   windows.add(truth, reading.elements);
                 });
  const auto tell = [](const char* what, const ConfusionMatrix& table) {
    std::printf("%s: pixel accuracy %.3f, class average %.3f, window overlap %.3f\n%s", what,
                table.accuracy(), table.class_average(), table.iou(kWindow),
                table.table(kClasses).c_str());
  };
  tell("maps alone", maps_alone);
  tell("maps and trees", with_tree);
  std::printf("windows of the trees: overlap %.3f\n", windows.overlap());
  // Nine facades give less training data than forty-two.
  const bool all = all_asked_for();
  EXPECT_GT(with_tree.accuracy(), all ? 0.80 : 0.75);
  EXPECT_GT(with_tree.iou(kWindow), all ? 0.50 : 0.40);
  EXPECT_GT(windows.overlap(), all ? 0.50 : 0.40);
}

TEST_F(Accuracy, WithoutTraining) {
  for (const char* likelihood : {"kt", "paper"}) {
    Windows windows;
    for (const LabelledImage& facade : facades()) {
      const ClusterImage clusters = cluster_image(&facade.photo, nullptr, {}, RandomKey(1));
      windows.add(
          facade,
          fit_facade(clusters.evidence(), rules_, options(likelihood), RandomKey(1)).elements);
    }
    std::printf("%s: windows of the trees: overlap %.3f\n", likelihood, windows.overlap());
    if (likelihood == std::string("kt")) {
      EXPECT_GT(windows.overlap(), 0.20);
    }
  }
}

/// Maps with the label as the certain class, or in every tenth pixel another class.
Planes flipped(const LabelledImage& facade, RandomKey key) {
  constexpr double kFlipped = 0.1;
  const auto others = static_cast<uint32_t>(kClasses.count() - 1);
  Planes out{
      facade.photo.width, facade.photo.height,
      std::vector<Plane>(kClasses.names.size(),
                         Plane(facade.labels.size(), static_cast<float>(kFlipped / others)))};
  RandomStream stream(key);
  for (size_t i = 0; i < facade.labels.size(); ++i) {
    size_t label = facade.labels[i];
    if (label == kUnlabelled) label = 4;
    if (stream.uniform() < kFlipped) label = (label + 1 + stream.below(others)) % (others + 1);
    out.planes[label][i] = static_cast<float>(1 - kFlipped);
  }
  return out;
}

TEST_F(Accuracy, LabelsWithATenthFlipped) {
  Windows windows;
  for (size_t k = 0; k < facades().size(); ++k) {
    // These maps are calibrated.
    const Evidence evidence = classifier_evidence(flipped(facades()[k], RandomKey(k)), kClasses,
                                                  {.windows = 1, .unnamed = 0});
    windows.add(facades()[k],
                fit_facade(evidence, rules_, options("supervised"), RandomKey(1)).elements);
  }
  std::printf("flipped labels: windows of the trees: overlap %.3f, mean over facades %.3f\n",
              windows.overlap(), windows.mean_overlap());
  EXPECT_GT(windows.overlap(), all_asked_for() ? 0.80 : 0.75);
}

/// Ten seeds per facade; nine must give the same tree.
TEST_F(Accuracy, DifferentSeedsGiveTheSameTree) {
  const size_t count = std::min<size_t>(facades().size(), all_asked_for() ? 12 : 1);
  size_t same = 0;
  for (size_t k = 0; k < count; ++k) {
    const LabelledImage& facade = facades()[k];
    const Evidence evidence =
        classifier_evidence(flipped(facade, RandomKey(k)), kClasses, {.windows = 1, .unnamed = 0});
    std::map<std::pair<double, std::string>, int> ends;
    for (uint64_t seed = 1; seed <= 10; ++seed) {
      const Report found =
          fit_facade(evidence, rules_, options("supervised"), RandomKey(seed)).report;
      ++ends[{found.bits, found.structure}];
    }
    int most = 0;
    for (const auto& [end, times] : ends) {
      std::printf("%s: %d of 10 at %.2f bits: %s\n", facade.name.c_str(), times, end.first,
                  end.second.c_str());
      most = std::max(most, times);
    }
    same += most >= 9 ? 1 : 0;
  }
  std::printf("the same tree from nine seeds of ten: %zu of %zu facades\n", same, count);
  // In grids with the maximum number of window kinds some trees differ by a pixel.
  EXPECT_GE(static_cast<double>(same), 0.9 * static_cast<double>(count));
}

}  // namespace
}  // namespace vug::fit
