// Classifiers of facades' pixels, trained on labelled pictures, and what they tell a sampler.
#pragma once

#include <vug/fit/evidence/evidence.h>
#include <vug/fit/learning/labelled_images.h>
#include <vug/fit/learning/random_forest.h>

namespace vug::fit {

struct PixelClassifierOptions {
  ForestOptions first;
  ForestOptions second{.tried_features = 20};
  int examples = 6000;         ///< Pixels of each picture, drawn at random,
  int max_examples = 500'000;  ///< and in all.
  uint64_t max_memory = 0;     ///< Bytes; 0: what is available.
};

/// Two forests: the first sees a pixel's surroundings, the second also what the first makes of
/// what is around. So that it learns how far to trust that, the maps of the first that the second
/// is trained on come from forests that have not seen the picture (cite wolpert1992).
class PixelClassifier {
 public:
  /// The same for any number of threads. Pictures are of one working size's limits, `limits`.
  /// Error(bad_input) where no pixel has a label, Error(too_large), before it begins, where the
  /// examples take more memory than there may be.
  static PixelClassifier train(const std::vector<const LabelledImage*>& pictures,
                               const Classes& classes, const WorkingLimits& limits,
                               const PixelClassifierOptions& options, RandomKey key,
                               Progress& progress = Progress::none());

  /// Error(bad_input) with a sentence for what is no such model, damaged, or of another version.
  static PixelClassifier from_json(const nlohmann::json& text);
  static PixelClassifier read(const std::filesystem::path& file);
  nlohmann::json to_json() const;

  const Classes& classes() const { return classes_; }
  const WorkingLimits& limits() const { return limits_; }

  /// How likely each pixel is of each class, one plane a class, at the photo's working_size (the
  /// photo's own where it is made smaller already).
  Planes classify(const image::Image& linear) const;

 private:
  Classes classes_;
  WorkingLimits limits_;
  Forest first_, second_;
};

/// Maps of another size, by the nearest four values.
Planes enlarged(const Planes& maps, int width, int height);

struct ClassifierEvidenceOptions {
  /// Odds of windows are taken for so many times as high as maps say. A grid whose cells are mostly
  /// right shares most with the true windows where pixels of a third are windows already.
  double windows = 2;
  /// Wall is all that no part of a tree stands for, so doors and shops may be wall too, with this
  /// part of their probability. Else a door is the best that a tree without a shop can say of one.
  double unnamed = 0.25;
  /// No pixel is taken for less likely, as maps err, and pixels err together.
  double min_probability = 0.02;
};

/// Evidence for the `supervised` likelihood: bits of each Look, in steps of kBitStep.
/// Error(bad_input) where the maps are not those of the classes.
Evidence classifier_evidence(const Planes& maps, const Classes& classes,
                             const ClassifierEvidenceOptions& options = {});

}  // namespace vug::fit
