// SPDX-License-Identifier: Apache-2.0
// How much a network resembles real caves: the place of each measure among 31 surveyed networks
// (collon2017karst in the form of 2021), the passage sizes among four surveyed regions, one number
// for all of them, and advice.
#pragma once

#include <vug/network/metrics.h>
#include <vug/network/section_statistics.h>

#include <array>

namespace vug::network {

/// Fractions of the caves that have at most the value at the same index of Criterion::quantiles.
inline constexpr std::array<double, 7> kQuantileFractions{0, 0.1, 0.25, 0.5, 0.75, 0.9, 1};

/// A measure of networks and its distribution among real caves.
struct Criterion {
  const char* name;
  std::array<double, 7> quantiles;  ///< Increasing; the first and last are the extremes.
  const char* too_low;              ///< Advice for a value below the 10 % quantile.
  const char* too_high;             ///< Advice for a value above the 90 % quantile.
  double (*value)(const Metrics&);  ///< NaN if it is undefined.
  const char* unit = "";
};

/// The ten criteria, in the order of Metrics. The path length is divided by the root of the number
/// of nodes, because it grows with the size of a cave.
const std::vector<Criterion>& criteria();

/// A statistic of passage sizes. Values from `low` to `high` occur in the surveyed regions; those
/// outside `lowest` to `highest` are regarded as impossible.
struct SectionCriterion {
  const char* name;
  double lowest, low, high, highest;
  const char* too_low;
  const char* too_high;
  double (*value)(const SectionSummary&);
  std::vector<double> regions;  ///< The values of the regions where it was measured, ascending.
  const char* unit = "";
};
const std::vector<SectionCriterion>& section_criteria();

/// The fraction of real caves with at most this value, by linear interpolation between quantiles;
/// 0 below the least, 1 above the largest, NaN for NaN.
double percentile(const Criterion& criterion, double value);
/// The same among the surveyed regions: the value of region i of n (from 0) is the quantile
/// (i + 1/2) / n, the outer limits are 0 and 1.
double percentile(const SectionCriterion& criterion, double value);

/// The name of a criterion with its unit if it has one, e.g. "median width (m)".
std::string label(const char* name, const char* unit);

/// Networks with fewer branches get no advice: their measures depend on single legs.
inline constexpr int kFewestBranches = 10;

/// The values of a criterion among real caves. Advice is given for values outside low to high.
struct RealRange {
  double lowest, low, median, high, highest;
};
RealRange range_of(const Criterion& criterion);
RealRange range_of(const SectionCriterion& criterion);

struct CriterionScore {
  std::string name;
  double value = 0;
  double percentile = 0;  ///< In 0..1; NaN for undefined values.
  double realism = 0;     ///< 1 in the band of real caves, 0 outside all of them; NaN if undefined.
  std::string advice;     ///< A sentence, or empty if the value is in the band.
};

struct Realism {
  std::vector<CriterionScore> network;
  std::vector<CriterionScore> sections;  ///< Empty without complete cross-sections.
  /// 0 to 100: the mean realism of the network's defined criteria, with a weight of 0.8, and of the
  /// sections' criteria, with a weight of 0.2. Without sections the weight of the network is 1.
  double overall = 0;

  /// The sentences of all criteria that have one.
  std::vector<std::string> advice() const;
};

/// The realism of a criterion is 1 from the 10 % to the 90 % quantile and falls linearly with the
/// percentile to 0 at the extremes; that of a section criterion falls linearly from the measured
/// band to its outer limits.
Realism score(const Metrics& metrics, const SectionSummary& sections = {});
Realism score(const Network& network);

}  // namespace vug::network
