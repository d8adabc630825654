// How well pixels are classified.
#pragma once

#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/pixel_classifier.h>

#include <functional>

namespace vug::fit {

/// Pixels by their class and by what they were taken for; those without a label do not count.
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

  /// Share of all pixels that are right; of the pixels of each class that there is, on average.
  /// 0 where there are none.
  double accuracy() const;
  double class_average() const;
  /// Pixels that are of the class and taken for it, by those that are either.
  double iou(int of) const;

  /// A table with a row for each class: how its pixels are spread over what they were taken for, in
  /// per cent, and its overlap.
  std::string table(const Classes& classes) const;

 private:
  int classes_;
  std::vector<int64_t> counts_;
};

/// Trains on all pictures but each `folds`th, for each of those parts, and calls
/// visit(picture, maps) with the maps of each picture by the model that has not seen it.
/// Error(bad_input) for fewer than two folds, or fewer pictures than folds.
void cross_validate(const std::vector<LabelledImage>& pictures, const Classes& classes,
                    const WorkingLimits& limits, const PixelClassifierOptions& options, int folds,
                    RandomKey key, const std::function<void(size_t, const Planes&)>& visit,
                    Progress& progress = Progress::none());

}  // namespace vug::fit
