// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/fit/json_integer.h>
#include <vug/fit/learning/random_forest.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace vug::fit {

namespace {

/// Votes of a leaf are integers from 1 to this.
constexpr double kMaxVotes = 250;

/// The value after writing it with five digits.
double rounded(float value) {
  const std::string text = fmt::format("{:.5g}", value);
  double out = 0;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}
float short_number(float value) { return static_cast<float>(rounded(value)); }

}  // namespace

/// Grows one tree, depth first.
class TreeGrower {
 public:
  TreeGrower(const Examples& examples, int classes, const ForestOptions& options, RandomKey key)
      : examples_(examples),
        classes_(static_cast<size_t>(classes)),
        options_(options),
        stream_(key) {}

  Forest::Tree grow() {
    const auto all = static_cast<uint32_t>(examples_.count());
    const auto count = static_cast<size_t>(std::max(1.0, options_.share * all));
    chosen_.reserve(count);
    for (size_t i = 0; i < count; ++i) chosen_.push_back(stream_.below(all));
    node(0, chosen_.size(), 0);
    return std::move(tree_);
  }

 private:
  using Counts = std::vector<double>;

  Counts count(size_t begin, size_t end) const {
    Counts out(classes_, 0);
    for (size_t i = begin; i < end; ++i) ++out[examples_.classes[chosen_[i]]];
    return out;
  }

  /// Gini purity: sum of squares divided by the sum; larger is purer.
  static double purity(const Counts& counts) {
    const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
    double squares = 0;
    for (const double n : counts) squares += n * n;
    return all > 0 ? squares / all : 0;
  }

  float value(size_t i, size_t feature) const { return examples_.at(chosen_[i])[feature]; }

  int node(size_t begin, size_t end, int depth) {
    const auto index = static_cast<int>(tree_.splits.size());
    tree_.splits.emplace_back();
    const Counts counts = count(begin, end);
    const bool pure =
        std::count(counts.begin(), counts.end(), 0.0) + 1 >= static_cast<std::ptrdiff_t>(classes_);
    size_t middle = begin;
    Forest::Split best;
    if (!pure && depth < options_.depth &&
        end - begin >= 2 * static_cast<size_t>(options_.min_leaf_size))
      best = best_split(begin, end, counts);
    if (best.feature >= 0) {
      const auto at = std::partition(
          chosen_.begin() + static_cast<std::ptrdiff_t>(begin),
          chosen_.begin() + static_cast<std::ptrdiff_t>(end), [&](uint32_t example) {
            return examples_.at(example)[static_cast<size_t>(best.feature)] < best.threshold;
          });
      middle = static_cast<size_t>(at - chosen_.begin());
    }
    if (middle == begin || middle == end) {
      best.feature = -1;
      best.left = static_cast<int>(tree_.votes.size());
      const double all = static_cast<double>(end - begin);
      for (const double n : counts)
        tree_.votes.push_back(static_cast<uint8_t>(std::max(1L, std::lround(kMaxVotes * n / all))));
    } else {
      best.left = node(begin, middle, depth + 1);
      best.right = node(middle, end, depth + 1);
    }
    tree_.splits[static_cast<size_t>(index)] = best;
    return index;
  }

  /// A feature with sorted thresholds, and the class counts of the intervals between them.
  struct SplitCandidate {
    size_t feature = 0;
    std::vector<float> thresholds;
    std::vector<uint32_t> counts;
  };

  SplitCandidate candidate(size_t begin, size_t end) {
    SplitCandidate out;
    out.feature = stream_.below(static_cast<uint32_t>(examples_.features));
    for (int k = 0; k < options_.tried_thresholds; ++k)
      out.thresholds.push_back(short_number(
          value(begin + stream_.below(static_cast<uint32_t>(end - begin)), out.feature)));
    std::sort(out.thresholds.begin(), out.thresholds.end());
    out.counts.assign((out.thresholds.size() + 1) * classes_, 0);
    return out;
  }

  Forest::Split best_split(size_t begin, size_t end, const Counts& counts) {
    std::vector<SplitCandidate> candidates;
    for (int i = 0; i < options_.tried_features; ++i) candidates.push_back(candidate(begin, end));
    // Loops over examples outside and candidates inside, because examples are far apart in memory.
    for (size_t at = begin; at < end; ++at) {
      const float* example = examples_.at(chosen_[at]);
      const size_t of = examples_.classes[chosen_[at]];
      for (SplitCandidate& candidate : candidates) {
        const float v = example[candidate.feature];
        size_t bin = 0;
        for (const float threshold : candidate.thresholds) bin += v >= threshold ? 1 : 0;
        ++candidate.counts[bin * classes_ + of];
      }
    }
    Forest::Split best;
    double best_purity = purity(counts) + 1e-9;
    const auto size = static_cast<double>(end - begin);
    for (const SplitCandidate& candidate : candidates) {
      Counts below(classes_, 0), above = counts;
      double under = 0;
      for (size_t k = 0; k < candidate.thresholds.size(); ++k) {
        for (size_t c = 0; c < classes_; ++c) {
          const double n = candidate.counts[k * classes_ + c];
          below[c] += n, above[c] -= n, under += n;
        }
        if (under < options_.min_leaf_size || size - under < options_.min_leaf_size) continue;
        const double found = purity(below) + purity(above);
        if (found <= best_purity) continue;
        best_purity = found;
        best.feature = static_cast<int>(candidate.feature);
        best.threshold = candidate.thresholds[k];
      }
    }
    return best;
  }

  const Examples& examples_;
  const size_t classes_;
  const ForestOptions& options_;
  RandomStream stream_;
  std::vector<uint32_t> chosen_;
  Forest::Tree tree_;
};

Forest Forest::train(const Examples& examples, int classes, const ForestOptions& options,
                     RandomKey key, Progress& progress) {
  if (examples.count() == 0 || examples.values.size() != examples.count() * examples.features)
    throw Error(ErrorCode::bad_input, "no examples to train on");
  for (const uint8_t c : examples.classes)
    if (c >= classes)
      throw Error(ErrorCode::bad_input, "an example has a class that is out of range");
  Forest out;
  out.classes_ = classes;
  out.features_ = examples.features;
  out.trees_.resize(static_cast<size_t>(options.trees));
  progress.begin("training", out.trees_.size());
  parallel_for(out.trees_.size(), [&](size_t i) {
    progress.check();
    out.trees_[i] = TreeGrower(examples, classes, options, key.at(i)).grow();
    progress.advance();
  });
  progress.end();
  return out;
}

Planes Forest::classify(const Planes& features) const {
  if (features.count() != features_)
    throw Error(ErrorCode::bad_input,
                "the classifier was trained on a different number of features");
  const auto classes = static_cast<size_t>(classes_);
  Planes out{features.width, features.height,
             std::vector<std::vector<float>>(classes, std::vector<float>(features.pixels()))};
  const auto width = static_cast<size_t>(features.width);
  parallel_for(static_cast<size_t>(features.height), [&](size_t y) {
    std::vector<float> pixel(features_), votes(classes);
    for (size_t i = y * width; i < (y + 1) * width; ++i) {
      for (size_t f = 0; f < features_; ++f) pixel[f] = features.planes[f][i];
      std::fill(votes.begin(), votes.end(), 0.0f);
      for (const Tree& tree : trees_) {
        const Split* split = tree.splits.data();
        while (split->feature >= 0)
          split = tree.splits.data() +
                  (pixel[static_cast<size_t>(split->feature)] < split->threshold ? split->left
                                                                                 : split->right);
        const uint8_t* leaf = tree.votes.data() + split->left;
        float sum = 0;
        for (size_t c = 0; c < classes; ++c) sum += leaf[c];
        for (size_t c = 0; c < classes; ++c) votes[c] += leaf[c] / sum;
      }
      for (size_t c = 0; c < classes; ++c)
        out.planes[c][i] = votes[c] / static_cast<float>(trees_.size());
    }
  });
  return out;
}

// Trees are written in the order of growth: each split before its descendants, so that no child
// indices are needed. A leaf is -1 among the features.
nlohmann::json Forest::to_json() const {
  nlohmann::json trees = nlohmann::json::array();
  for (const Tree& tree : trees_) {
    nlohmann::json features = nlohmann::json::array(), thresholds = nlohmann::json::array();
    for (const Split& split : tree.splits) {
      features.push_back(split.feature);
      if (split.feature >= 0) thresholds.push_back(rounded(split.threshold));
    }
    trees.push_back({{"features", features}, {"thresholds", thresholds}, {"votes", tree.votes}});
  }
  return {{"classes", classes_}, {"features", features_}, {"trees", trees}};
}

Forest::Tree Forest::tree_from_json(const nlohmann::json& text) const {
  constexpr int kNone = -2;
  std::vector<int> features;
  for (const nlohmann::json& feature : text.at("features"))
    features.push_back(json_integer(feature).value_or(kNone));
  std::vector<float> thresholds;
  for (const nlohmann::json& threshold : text.at("thresholds")) {
    const auto value = threshold.get<double>();
    if (!(std::fabs(value) < 1e30)) return {};
    thresholds.push_back(static_cast<float>(value));
  }
  Tree tree;
  for (const nlohmann::json& vote : text.at("votes")) {
    const int count = json_integer(vote).value_or(kNone);
    if (count < 1 || count > kMaxVotes) return {};
    tree.votes.push_back(static_cast<uint8_t>(count));
  }
  size_t split_count = 0, leaves = 0;
  std::vector<size_t> open;  // Splits whose right child is still missing.
  for (size_t i = 0; i < features.size(); ++i) {
    Split split;
    split.feature = features[i];
    if (split.feature >= static_cast<int>(features_) || split.feature < -1) return {};
    if (i > 0 && features[i - 1] < 0) {
      // The node after a leaf is the right child of the last open split.
      if (open.empty()) return {};
      tree.splits[open.back()].right = static_cast<int>(i);
      open.pop_back();
    }
    if (split.feature >= 0) {
      if (split_count == thresholds.size()) return {};
      split.threshold = thresholds[split_count++];
      split.left = static_cast<int>(i) + 1;
      open.push_back(i);
    } else {
      split.left = static_cast<int>(leaves++ * static_cast<size_t>(classes_));
    }
    tree.splits.push_back(split);
  }
  const bool whole = open.empty() && !features.empty() && features.back() < 0 &&
                     split_count == thresholds.size() &&
                     tree.votes.size() == leaves * static_cast<size_t>(classes_);
  return whole ? tree : Tree{};
}

Forest Forest::from_json(const nlohmann::json& text) {
  const Error damaged(ErrorCode::bad_input, "the classifier is damaged", {}, "train it again");
  Forest out;
  try {
    out.classes_ = json_integer(text.at("classes")).value_or(0);
    const int features = json_integer(text.at("features")).value_or(0);
    if (out.classes_ < 1 || out.classes_ > 255 || features < 1) throw damaged;
    out.features_ = static_cast<size_t>(features);
    for (const nlohmann::json& from : text.at("trees")) {
      out.trees_.push_back(out.tree_from_json(from));
      if (out.trees_.back().splits.empty()) throw damaged;
    }
  } catch (const nlohmann::json::exception&) {
    throw damaged;
  }
  if (out.trees_.empty()) throw damaged;
  return out;
}

}  // namespace vug::fit
