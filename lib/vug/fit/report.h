// SPDX-License-Identifier: Apache-2.0
// Diagnostics of a facade fit: scores, posterior and convergence. Plain data; nothing is written to
// files here.
#pragma once

#include <vug/fit/search/sampler.h>
#include <vug/inference/convergence.h>

#include <optional>

namespace vug::fit {

/// Posterior probability of one structure.
struct StructureProbability {
  std::string structure;      ///< Text from structure_of.
  double probability = 0;     ///< Share of the rounds of the coldest chains.
  double standard_error = 0;  ///< Takes the autocorrelation of rounds into account.
};

struct MoveRate {
  std::string name;
  inference::MoveCount count;  ///< Summed over the coldest chains of all runs.
};

struct Report {
  std::string structure;
  double bits = 0;        ///< Bits of the tree and the weighted pixels.
  double complexity = 0;  ///< c(T): bits of the tree alone.
  double wall_bits = 0;   ///< Bits of the picture as wall only.
  double seed_bits = 0;   ///< Bits of the best seed.
  double chain_bits = 0;  ///< Bits of the best tree of the chains, before refinement.
  double score = 0;       ///< s(T) in 0..1 (cite ripperda2009).
  /// maxComp: bits of the most complex tree, the reference of the score.
  double max_complexity = 0;
  double misfit = 0;  ///< diffPixel(T) log2(numCluster), of the same reference.

  std::vector<StructureProbability> posterior;  ///< Most frequent structures first.
  /// Sum of the effective sample sizes of the energy traces.
  double effective_size = 0;
  /// Split R-hat between and within the runs of the energies, and of the numbers of elements.
  double scale_reduction = 1;
  double elements_scale_reduction = 1;
  double geweke = 0;                 ///< The z-score of the runs that is furthest from 0.
  std::vector<double> temperatures;  ///< Temperatures of the first run.
  std::vector<double> swap_rates;    ///< Exchange rates between neighbours, over all runs.
  std::vector<MoveRate> moves;
  std::vector<inference::Trace> traces;  ///< Energies of the coldest chain, per run.
  std::vector<double> mean_elements;     ///< Mean number of its elements, per run.
  bool supervised = false;               ///< Whether a trained classifier gave the evidence.
  bool stopped = false;                  ///< Whether the fit was cancelled.
};

/// Largest R-hat of runs that agree (cite gelman2013).
constexpr double kMaxScaleReduction = 1.1;

struct ReportWarning {
  std::string message, hint;
};

/// A warning if the runs disagree, so that another seed would probably give another tree; nothing
/// if they agree, if there is a single run, or if the fit was cancelled.
std::optional<ReportWarning> disagreement(const Report& report);

/// Summarises independent runs; the scores stay 0.
Report make_report(const std::vector<SamplerResult>& runs);

/// Adds the published score 1 - (c(T) + misfit) / (max complexity + pixels log2(lanes)). The misfit
/// is that of the likelihood `paper`; for supervised evidence it is the bits of the pixels, limited
/// to pixels log2(lanes).
void add_score(Report& report, const Model& model, const Evidence& evidence, const Tree& tree);

/// maxComp: bits of the most complex tree with splits nested at most `depth` deep.
double max_complexity(const Model& model, int depth = 6);

/// The report as JSON; traces are thinned to at most 1,000 values each.
std::string report_json(const Report& report);
/// A self-contained SVG with traces, temperatures, exchange rates, moves and structures.
std::string report_svg(const Report& report);

}  // namespace vug::fit
