// SPDX-License-Identifier: Apache-2.0
// Facade reconstruction from a picture, from evidence to tree, with good defaults.
#pragma once

#include <vug/fit/report.h>
#include <vug/fit/search/seeds.h>

namespace vug::fit {

struct FitOptions {
  /// Name of a likelihood; `supervised` for evidence from a pixel classifier.
  std::string likelihood = "kt";
  /// Weight of the pixels' bits, below 1 because neighbouring pixels are not independent.
  double pixel_weight = 0.1;
  Limits limits;
  SeedOptions seeds;
  SamplerOptions sampler;
  int runs = 2;  ///< Independent runs from different seeds, compared by the report.
};

/// An element found in the picture.
struct DetectedElement {
  RegionType type = RegionType::window;
  int node = 0;  ///< The terminal in the tree.
  Rect rect;     ///< Pixels; row 0 is the top row.
  bool operator==(const DetectedElement&) const = default;
};

struct FitResult {
  Tree tree;
  std::vector<DetectedElement> elements;  ///< All instances, in the order of nodes.
  /// Diagnostics of the run; its bits are those of the tree.
  Report report;
};

/// Finds the most likely tree of the rules for the evidence: seeds, Markov chains, and a final
/// local refinement. If cancelled it returns the best tree so far. The result does not depend on
/// the number of threads. Error(bad_input) for an unknown likelihood, unsuitable evidence, or zero
/// runs.
FitResult fit_facade(const Evidence& evidence, const Rules& rules, const FitOptions& options,
                     RandomKey key, Progress& progress = Progress::none());

}  // namespace vug::fit
