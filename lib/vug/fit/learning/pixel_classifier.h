// SPDX-License-Identifier: Apache-2.0
// Pixel classifiers for facades, trained on labelled pictures, and the evidence derived from them.
#pragma once

#include <vug/fit/evidence/evidence.h>
#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/random_forest.h>

namespace vug::fit {

struct PixelClassifierOptions {
  ForestOptions first;
  ForestOptions second{.tried_features = 20};
  int examples = 6000;         ///< Random pixels per picture.
  int max_examples = 500'000;  ///< Limit over all pictures.
  uint64_t max_memory = 0;     ///< Bytes; 0: the available memory.
};

/// Two stacked random forests: the first sees a pixel's surroundings, the second also the first
/// one's predictions around it. The predictions used to train the second forest come from forests
/// that were not trained on the same picture (cite wolpert1992), so that it learns how far to trust
/// them.
class PixelClassifier {
 public:
  /// The result does not depend on the number of threads. `limits` are the working size's limits
  /// for which the pictures were prepared. Error(bad_input) if no pixel is labelled;
  /// Error(too_large), before training starts, if the examples exceed the memory limit.
  static PixelClassifier train(const std::vector<const LabelledImage*>& pictures,
                               const Classes& classes, const WorkingLimits& limits,
                               const PixelClassifierOptions& options, RandomKey key,
                               Progress& progress = Progress::none());

  /// Error(bad_input) with a sentence for a file that is not such a model, is damaged, or has
  /// another version.
  static PixelClassifier from_json(const nlohmann::json& text);
  static PixelClassifier read(const std::filesystem::path& file);
  nlohmann::json to_json() const;

  const Classes& classes() const { return classes_; }
  const WorkingLimits& limits() const { return limits_; }

  /// Class probabilities, one plane per class, at the photo's working_size (its own size if it is
  /// already small enough).
  Planes classify(const image::Image& linear) const;

 private:
  Classes classes_;
  WorkingLimits limits_;
  Forest first_, second_;
};

/// Resizes maps with bilinear interpolation.
Planes enlarged(const Planes& maps, int width, int height);

struct ClassifierEvidenceOptions {
  /// Factor on the odds of windows. A grid whose cells are mostly right overlaps most with the true
  /// windows if pixels with a probability of one third already count as windows.
  double windows = 2;
  /// Share of the probability of doors and shops that also counts as wall: wall is everything that
  /// no part of a tree represents. Without it a tree without shops is best off calling a shop a
  /// door.
  double unnamed = 0.25;
  /// Lower bound of every probability, because maps err and their errors are correlated.
  double min_probability = 0.02;
};

/// Evidence for the `supervised` likelihood: bits under each RegionType in steps of kBitStep.
/// Error(bad_input) if the maps do not match the classes.
Evidence classifier_evidence(const Planes& maps, const Classes& classes,
                             const ClassifierEvidenceOptions& options = {});

}  // namespace vug::fit
