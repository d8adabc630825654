// SPDX-License-Identifier: Apache-2.0
// The published score of any facade tree against the clusters of a picture, and the pixels that
// contradict the tree.
#pragma once

#include <vug/facade/rules.h>
#include <vug/facade/tree.h>
#include <vug/fit/evidence/cluster_image.h>
#include <vug/fit/model/model.h>

namespace vug::fit {

/// c(T), s(T) and the misfit of ripperda2009, section 6.
struct FacadeScore {
  double complexity = 0;  ///< c(T): bits of the tree.
  double misfit = 0;      ///< diffPixel(T) log2(numCluster), bits.
  double score = 0;       ///< s(T) in 0..1.
  size_t differing = 0;   ///< diffPixel(T): pixels outside of the main cluster of their region.
  /// 1 for each differing pixel, row by row from the top.
  std::vector<uint8_t> mask;
};

/// Scores trees of one grammar and one picture.
class FacadeScorer {
 public:
  /// Error(bad_input) for rules that compile() refuses.
  FacadeScorer(facade::Rules text, ClusterImage clusters);
  FacadeScorer(const FacadeScorer&) = delete;
  FacadeScorer& operator=(const FacadeScorer&) = delete;

  int width() const { return clusters_.width; }
  int height() const { return clusters_.height; }
  /// The regions are those of fit::Model: the windows of a grid, each other element, and the wall
  /// of each node; areas that are not divided yet are wall. The tree covers the whole picture.
  FacadeScore score(const facade::Tree& tree) const;

 private:
  facade::Rules text_;
  Rules rules_;
  ClusterImage clusters_;
  Model model_;
  double max_complexity_ = 0;
};

}  // namespace vug::fit
