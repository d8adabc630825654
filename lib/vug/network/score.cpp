// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/network/graph.h>
#include <vug/network/score.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::network {
namespace {

constexpr double kTail = kQuantileFractions[1];
constexpr double kSectionWeight = 0.2;

/// Advice for a value outside a band, e.g. "the legs are too straight: tortuosity 1.04; real caves
/// have 1.18 to 1.42".
template <class AnyCriterion>
std::string advice_for(const AnyCriterion& criterion, double value) {
  const RealRange real = range_of(criterion);
  if (!(value < real.low || value > real.high)) return {};
  return fmt::format("{}: {} {:.3g}; real caves have {:.3g} to {:.3g}",
                     value < real.low ? criterion.too_low : criterion.too_high, criterion.name,
                     value, real.low, real.high);
}

/// The ordinate at `x` of a line through points with ascending x: 0 below the first, 1 above the
/// last, NaN for NaN.
double interpolate(const std::vector<std::pair<double, double>>& points, double x) {
  if (std::isnan(x)) return kUndefined;
  if (x <= points.front().first) return 0;
  if (x >= points.back().first) return 1;
  size_t i = 1;
  while (x > points[i].first) ++i;
  const auto& [x0, y0] = points[i - 1];
  const auto& [x1, y1] = points[i];
  return y0 + (x - x0) / (x1 - x0) * (y1 - y0);
}

CriterionScore score_of(const Criterion& criterion, const Metrics& metrics) {
  const double value = criterion.value(metrics);
  const double place = percentile(criterion, value);
  CriterionScore result{criterion.name, value, place, kUndefined, {}};
  if (std::isnan(place)) return result;
  result.realism = std::min({1.0, place / kTail, (1 - place) / kTail});
  result.advice = advice_for(criterion, value);
  return result;
}

CriterionScore score_of(const SectionCriterion& criterion, const SectionSummary& sections) {
  const double value = criterion.value(sections);
  CriterionScore result{criterion.name, value, percentile(criterion, value), kUndefined, {}};
  if (std::isnan(value)) return result;
  const double above = (value - criterion.lowest) / (criterion.low - criterion.lowest);
  const double below = (criterion.highest - value) / (criterion.highest - criterion.high);
  result.realism = std::clamp(std::min(above, below), 0.0, 1.0);
  result.advice = advice_for(criterion, value);
  return result;
}

/// NaN without defined criteria.
double mean_realism(const std::vector<CriterionScore>& scores) {
  double sum = 0;
  int count = 0;
  for (const CriterionScore& s : scores) {
    if (std::isnan(s.realism)) continue;
    sum += s.realism;
    ++count;
  }
  return count > 0 ? sum / count : kUndefined;
}

}  // namespace

double percentile(const Criterion& criterion, double value) {
  std::vector<std::pair<double, double>> points;
  for (size_t i = 0; i < kQuantileFractions.size(); ++i)
    points.emplace_back(criterion.quantiles[i], kQuantileFractions[i]);
  return interpolate(points, value);
}

double percentile(const SectionCriterion& criterion, double value) {
  const auto count = static_cast<double>(criterion.regions.size());
  std::vector<std::pair<double, double>> points{{criterion.lowest, 0}};
  for (size_t i = 0; i < criterion.regions.size(); ++i)
    points.emplace_back(criterion.regions[i], (static_cast<double>(i) + 0.5) / count);
  points.emplace_back(criterion.highest, 1);
  return interpolate(points, value);
}

std::string label(const char* name, const char* unit) {
  return *unit ? fmt::format("{} ({})", name, unit) : name;
}

RealRange range_of(const Criterion& criterion) {
  const auto& q = criterion.quantiles;
  return {q[0], q[1], q[3], q[5], q[6]};
}

RealRange range_of(const SectionCriterion& criterion) {
  const std::vector<double>& r = criterion.regions;
  const double middle = (r[(r.size() - 1) / 2] + r[r.size() / 2]) / 2;
  return {criterion.lowest, criterion.low, middle, criterion.high, criterion.highest};
}

std::vector<std::string> Realism::advice() const {
  std::vector<std::string> sentences;
  for (const auto* scores : {&network, &sections})
    for (const CriterionScore& s : *scores)
      if (!s.advice.empty()) sentences.push_back(s.advice);
  return sentences;
}

Realism score(const Metrics& metrics, const SectionSummary& sections) {
  Realism result;
  for (const Criterion& criterion : criteria())
    result.network.push_back(score_of(criterion, metrics));
  if (sections.count > 0)
    for (const SectionCriterion& criterion : section_criteria())
      result.sections.push_back(score_of(criterion, sections));
  if (metrics.edges < kFewestBranches)
    for (CriterionScore& each : result.network) each.advice.clear();
  const double of_network = mean_realism(result.network);
  const double of_sections = mean_realism(result.sections);
  double mean = of_network;
  if (!std::isnan(of_sections))
    mean = std::isnan(of_network)
               ? of_sections
               : (1 - kSectionWeight) * of_network + kSectionWeight * of_sections;
  result.overall = std::isnan(mean) ? 0 : 100 * mean;
  return result;
}

Realism score(const Network& network) { return score(measure(network), measure_sections(network)); }

}  // namespace vug::network
