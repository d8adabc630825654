#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/fit/forest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>

namespace vug::fit {

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

  /// Gini's: the sum of squares by the sum, the larger the purer.
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
    if (!pure && depth < options_.depth && end - begin >= 2 * static_cast<size_t>(options_.least))
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
      const double all = static_cast<double>(end - begin) + 0.1 * static_cast<double>(classes_);
      for (const double n : counts) tree_.votes.push_back(static_cast<float>((n + 0.1) / all));
    } else {
      best.left = node(begin, middle, depth + 1);
      best.right = node(middle, end, depth + 1);
    }
    tree_.splits[static_cast<size_t>(index)] = best;
    return index;
  }

  Forest::Split best_split(size_t begin, size_t end, const Counts& counts) {
    Forest::Split best;
    double best_purity = purity(counts) + 1e-9;
    const auto size = static_cast<uint32_t>(end - begin);
    for (int i = 0; i < options_.tried_features; ++i) {
      const auto feature = stream_.below(static_cast<uint32_t>(examples_.features));
      std::vector<float> thresholds;
      for (int k = 0; k < options_.tried_thresholds; ++k)
        thresholds.push_back(value(begin + stream_.below(size), feature));
      std::sort(thresholds.begin(), thresholds.end());
      // Between each two thresholds, how many of each class.
      std::vector<Counts> bins(thresholds.size() + 1, Counts(classes_, 0));
      for (size_t at = begin; at < end; ++at) {
        const float v = value(at, feature);
        const auto bin = std::upper_bound(thresholds.begin(), thresholds.end(), v);
        ++bins[static_cast<size_t>(bin - thresholds.begin())][examples_.classes[chosen_[at]]];
      }
      Counts below(classes_, 0), above = counts;
      double under = 0;
      for (size_t k = 0; k < thresholds.size(); ++k) {
        for (size_t c = 0; c < classes_; ++c) {
          below[c] += bins[k][c], above[c] -= bins[k][c];
          under += bins[k][c];
        }
        if (under < options_.least || size - under < options_.least) continue;
        const double found = purity(below) + purity(above);
        if (found <= best_purity) continue;
        best_purity = found;
        best.feature = static_cast<int>(feature);
        best.threshold = thresholds[k];
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
    throw Error(ErrorCode::bad_input, "there are no examples to train on");
  for (const uint8_t c : examples.classes)
    if (c >= classes) throw Error(ErrorCode::bad_input, "an example has a class that there is not");
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
    throw Error(ErrorCode::bad_input, "the classifier was trained on other features");
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
        for (size_t c = 0; c < classes; ++c)
          votes[c] += tree.votes[static_cast<size_t>(split->left) + c];
      }
      for (size_t c = 0; c < classes; ++c)
        out.planes[c][i] = votes[c] / static_cast<float>(trees_.size());
    }
  });
  return out;
}

nlohmann::json Forest::to_json() const {
  nlohmann::json trees = nlohmann::json::array();
  for (const Tree& tree : trees_) {
    nlohmann::json splits = nlohmann::json::array();
    for (const Split& s : tree.splits) splits.push_back({s.feature, s.threshold, s.left, s.right});
    trees.push_back({{"splits", splits}, {"votes", tree.votes}});
  }
  return {{"classes", classes_}, {"features", features_}, {"trees", trees}};
}

Forest Forest::from_json(const nlohmann::json& text) {
  const auto damaged = [] {
    return Error(ErrorCode::bad_input, "the classifier is damaged", {}, "train it again");
  };
  Forest out;
  try {
    out.classes_ = text.at("classes");
    out.features_ = text.at("features");
    for (const nlohmann::json& from : text.at("trees")) {
      Tree tree;
      tree.votes = from.at("votes").get<std::vector<float>>();
      for (const nlohmann::json& s : from.at("splits"))
        tree.splits.push_back({s.at(0), s.at(1), s.at(2), s.at(3)});
      // Children stand behind their parents, so that every walk ends.
      const auto count = static_cast<int>(tree.splits.size());
      for (int i = 0; i < count; ++i) {
        const Split& s = tree.splits[static_cast<size_t>(i)];
        const bool leaf_fits =
            s.left >= 0 &&
            static_cast<size_t>(s.left) + static_cast<size_t>(out.classes_) <= tree.votes.size();
        const bool split_fits = s.feature < static_cast<int>(out.features_) && s.left > i &&
                                s.right > i && s.left < count && s.right < count;
        if (s.feature < 0 ? !leaf_fits : !split_fits) throw damaged();
      }
      if (tree.splits.empty()) throw damaged();
      out.trees_.push_back(std::move(tree));
    }
  } catch (const nlohmann::json::exception&) {
    throw damaged();
  }
  if (out.trees_.empty() || out.classes_ < 1 || out.classes_ > 255) throw damaged();
  return out;
}

}  // namespace vug::fit
