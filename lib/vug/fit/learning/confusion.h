// SPDX-License-Identifier: Apache-2.0
// Accuracy measures of pixel classification.
#pragma once

#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/pixel_classifier.h>

#include <functional>

namespace vug::fit {

/// Pixel counts by true class and predicted class; unlabelled pixels are ignored.
class ConfusionMatrix {
 public:
  explicit ConfusionMatrix(int classes);

  void add(const std::vector<uint8_t>& truth, const std::vector<uint8_t>& found);
  ConfusionMatrix& operator+=(const ConfusionMatrix& other);

  int classes() const { return classes_; }
  int64_t count(int truth, int found) const {
    return counts_[static_cast<size_t>(truth * classes_ + found)];
  }
  int64_t class_count(int truth) const;

  /// Overall accuracy, and the mean of the per-class accuracies over the classes that occur. 0
  /// without pixels.
  double accuracy() const;
  double class_average() const;
  /// Intersection over union of the class.
  double iou(int of) const;

  /// A table with one row per class: the distribution of its pixels over the predictions in per
  /// cent, and its intersection over union.
  std::string table(const Classes& classes) const;

 private:
  int classes_;
  std::vector<int64_t> counts_;
};

struct CrossValidation {
  WorkingLimits limits{};
  PixelClassifierOptions classifier{};
  int folds = 5;
};

/// Cross-validation: trains on all pictures but every `folds`th and calls
/// visit(picture, maps) with the maps of each picture from the model that was not trained on it.
/// Error(bad_input) for fewer than two folds, or fewer pictures than folds.
void cross_validate(const std::vector<LabelledImage>& pictures, const Classes& classes,
                    const CrossValidation& options, RandomKey key,
                    const std::function<void(size_t, const Planes&)>& visit,
                    Progress& progress = Progress::none());

}  // namespace vug::fit
