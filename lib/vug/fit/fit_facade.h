// A facade out of a picture, from evidence to tree: the whole chain with good defaults.
#pragma once

#include <vug/fit/report.h>
#include <vug/fit/search/seeds.h>

namespace vug::fit {

struct FitOptions {
  std::string likelihood = "kt";  ///< `supervised` where the evidence is of looks.
  /// How much the bits of a pixel count: neighbours are no independent witnesses.
  double pixel_weight = 0.1;
  Limits limits;
  SeedOptions seeds;
  SamplerOptions sampler;
  int runs =
      2;  ///< Independent of each other, from seeds of their own, to hold against each other.
};

/// What is seen somewhere in the picture.
struct DetectedElement {
  RegionType type = RegionType::window;
  int node = 0;  ///< The terminal of the tree.
  Rect rect;     ///< In pixels, the top row being 0.
  bool operator==(const DetectedElement&) const = default;
};

struct FitResult {
  Tree tree;
  std::vector<DetectedElement> elements;  ///< Everywhere, in the order of nodes.
  Report report;                          ///< Of how it was found; its bits are those of the tree.
};

/// Reads the tree of rules that the evidence is likely to be of: seeds, chains, and a polish.
/// When told to stop it returns the best so far. The same for any number of threads.
/// Error(bad_input) for unknown likelihoods, evidence that does not suit them and no runs.
FitResult fit_facade(const Evidence& evidence, const Rules& rules, const FitOptions& options,
                     RandomKey key, Progress& progress = Progress::none());

}  // namespace vug::fit
