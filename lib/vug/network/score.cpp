// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/network/graph.h>
#include <vug/network/score.h>

#include <algorithm>
#include <cmath>

namespace vug::network {
namespace {

constexpr double kTail = kQuantileFractions[1];
constexpr double kSectionWeight = 0.2;

/// Advice for a value outside a band, e.g. "the legs are too straight: tortuosity 1.04; real caves
/// have 1.18 to 1.42".
template <class AnyCriterion>
std::string advice_for(const AnyCriterion& criterion, double value, double low, double high) {
  if (!(value < low || value > high)) return {};
  return fmt::format("{}: {} {:.3g}; real caves have {:.3g} to {:.3g}",
                     value < low ? criterion.too_low : criterion.too_high, criterion.name, value,
                     low, high);
}

CriterionScore score_of(const Criterion& criterion, const Metrics& metrics) {
  const double value = criterion.value(metrics);
  const double place = percentile(criterion, value);
  CriterionScore result{criterion.name, value, place, kUndefined, {}};
  if (std::isnan(place)) return result;
  result.realism = std::min({1.0, place / kTail, (1 - place) / kTail});
  result.advice = advice_for(criterion, value, criterion.quantiles[1], criterion.quantiles[5]);
  return result;
}

CriterionScore score_of(const SectionCriterion& criterion, const SectionSummary& sections) {
  const double value = criterion.value(sections);
  CriterionScore result{criterion.name, value, kUndefined, kUndefined, {}};
  if (std::isnan(value)) return result;
  const double above = (value - criterion.lowest) / (criterion.low - criterion.lowest);
  const double below = (criterion.highest - value) / (criterion.highest - criterion.high);
  result.realism = std::clamp(std::min(above, below), 0.0, 1.0);
  result.advice = advice_for(criterion, value, criterion.low, criterion.high);
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
  const auto& q = criterion.quantiles;
  if (std::isnan(value)) return kUndefined;
  if (value <= q.front()) return 0;
  if (value >= q.back()) return 1;
  size_t i = 1;
  while (value > q[i]) ++i;
  const double t = (value - q[i - 1]) / (q[i] - q[i - 1]);
  return kQuantileFractions[i - 1] + t * (kQuantileFractions[i] - kQuantileFractions[i - 1]);
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
