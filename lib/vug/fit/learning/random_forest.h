// SPDX-License-Identifier: Apache-2.0
// Random forests (cite breiman2001): decision trees with thresholds that vote on a pixel's class.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/rng.h>
#include <vug/fit/evidence/features.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace vug::fit {

/// Training examples; `values` holds the features of one example after the other.
struct Examples {
  size_t features = 0;
  std::vector<float> values;
  std::vector<uint8_t> classes;

  size_t count() const { return classes.size(); }
  const float* at(size_t i) const { return values.data() + i * features; }
};

struct ForestOptions {
  int trees = 24;
  int depth = 16;             ///< Maximum depth of a tree.
  int min_leaf_size = 12;     ///< Minimum number of examples in a leaf.
  int tried_features = 12;    ///< Random features tried per node.
  int tried_thresholds = 10;  ///< Random thresholds tried per feature.
  double share = 0.4;         ///< Share of the examples that each tree is grown from.
};

class Forest {
 public:
  /// Grows the trees in parallel; the result does not depend on the number of threads.
  /// Error(bad_input) without examples, or for a class index of `classes` or more.
  static Forest train(const Examples& examples, int classes, const ForestOptions& options,
                      RandomKey key, Progress& progress = Progress::none());
  /// Error(bad_input) if the text is damaged.
  static Forest from_json(const nlohmann::json& text);
  nlohmann::json to_json() const;

  int classes() const { return classes_; }
  size_t features() const { return features_; }
  /// Class probabilities, one plane each, above 0 and summing to 1. Error(bad_input) if the number
  /// of planes differs from the training features.
  Planes classify(const Planes& features) const;

 private:
  struct Split {
    int feature = -1;  ///< -1: a leaf.
    float threshold = 0;
    /// Children below and not below the threshold. In a leaf `left` is the offset of its votes.
    int left = 0, right = 0;
  };
  struct Tree {
    std::vector<Split> splits;
    std::vector<uint8_t> votes;  ///< `classes` entries per leaf.
  };
  /// Has no splits if the text is damaged.
  Tree tree_from_json(const nlohmann::json& text) const;
  friend class TreeGrower;

  int classes_ = 0;
  size_t features_ = 0;
  std::vector<Tree> trees_;
};

}  // namespace vug::fit
