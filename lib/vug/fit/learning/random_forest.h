// Random forests (cite breiman2001): trees of thresholds that vote on a pixel's class.
#pragma once

#include <vug/base/progress.h>
#include <vug/base/rng.h>
#include <vug/fit/evidence/features.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace vug::fit {

/// Examples: `values` holds the features of one after the other.
struct Examples {
  size_t features = 0;
  std::vector<float> values;
  std::vector<uint8_t> classes;

  size_t count() const { return classes.size(); }
  const float* at(size_t i) const { return values.data() + i * features; }
};

struct ForestOptions {
  int trees = 24;
  int depth = 16;             ///< Of a tree, at most.
  int min_leaf_size = 12;     ///< Examples in a leaf, at least.
  int tried_features = 12;    ///< In each node, drawn at random,
  int tried_thresholds = 10;  ///< and thresholds of each.
  double share = 0.4;         ///< Of the examples that each tree is grown from.
};

class Forest {
 public:
  /// Grows the trees in parallel; the same forest for any number of threads. Error(bad_input) for
  /// no examples, or classes beyond `classes`.
  static Forest train(const Examples& examples, int classes, const ForestOptions& options,
                      RandomKey key, Progress& progress = Progress::none());
  /// Error(bad_input) where it is damaged.
  static Forest from_json(const nlohmann::json& text);
  nlohmann::json to_json() const;

  int classes() const { return classes_; }
  size_t features() const { return features_; }
  /// Probabilities of the classes, one plane each, above 0 and summing to 1.
  /// Error(bad_input) where the planes are not those it was trained on.
  Planes classify(const Planes& features) const;

 private:
  struct Split {
    int feature = -1;  ///< -1: a leaf.
    float threshold = 0;
    int left = 0, right = 0;  ///< Below the threshold, and not. A leaf: left is its votes' place.
  };
  struct Tree {
    std::vector<Split> splits;
    std::vector<uint8_t> votes;  ///< `classes` for each leaf.
  };
  /// Without splits where it is damaged.
  Tree tree_from_json(const nlohmann::json& text) const;
  friend class TreeGrower;

  int classes_ = 0;
  size_t features_ = 0;
  std::vector<Tree> trees_;
};

}  // namespace vug::fit
