// What reading a facade tells beside the tree: scores, the posterior, and whether chains ran long
// enough. Plain data; nothing is written to files here.
#pragma once

#include <vug/fit/search/sampler.h>
#include <vug/inference/convergence.h>

namespace vug::fit {

/// How much of the posterior has one structure.
struct StructureProbability {
  std::string structure;      ///< As structure_of.
  double probability = 0;     ///< Of all rounds of the coldest chains.
  double standard_error = 0;  ///< Its standard error, rounds being as independent as they are.
};

struct MoveRate {
  std::string name;
  inference::MoveCount count;  ///< Of the coldest chains of all runs.
};

struct Report {
  std::string structure;
  double bits = 0;            ///< Of the tree and the pixels under it, these as much as is trusted.
  double complexity = 0;      ///< c(T): bits of the tree alone.
  double wall_bits = 0;       ///< Of the picture as nothing but wall,
  double seed_bits = 0;       ///< of the best seed,
  double chain_bits = 0;      ///< and of the best tree of the chains, before it was polished.
  double score = 0;           ///< s(T) in 0..1 (cite ripperda2009),
  double max_complexity = 0;  ///< with maxComp, of the most complex tree that it compares to,
  double misfit = 0;          ///< and diffPixel(T) log2(numCluster), of that likelihood.

  std::vector<StructureProbability> posterior;  ///< The most frequent structures first.
  double effective_size = 0;                    ///< Of the traces of energies together.
  double scale_reduction = 1;        ///< Split R-hat of energies between and within the runs.
  double geweke = 0;                 ///< The z-score furthest from 0 of the runs.
  std::vector<double> temperatures;  ///< Of the first run.
  std::vector<double> swap_rates;    ///< Between neighbours, in all runs.
  std::vector<MoveRate> moves;
  std::vector<inference::Trace> traces;  ///< Energies of the coldest chain, of each run.
  bool stopped = false;                  ///< Before the end, by whoever watched.
};

/// From runs that are independent of one another; the scores stay 0.
Report make_report(const std::vector<SamplerResult>& runs);

/// 1 - (c(T) + misfit) / (most complexity + pixels log2(lanes)): the published score. The misfit is
/// that of the likelihood `paper`; of maps of looks their bits, as far as they are below the most.
void add_score(Report& report, const Model& model, const Evidence& evidence, const Tree& tree);

/// maxComp: bits of the most complex tree whose splits lie at most that deep in each other.
double max_complexity(const Model& model, int depth = 6);

/// All of it as JSON, traces thinned to at most 1,000 values each.
std::string report_json(const Report& report);
/// A drawing of traces, temperatures, swaps, moves and structures that needs nothing else.
std::string report_svg(const Report& report);

}  // namespace vug::fit
