// SPDX-License-Identifier: Apache-2.0
#include <vug/network/score_report.h>

#include <fmt/format.h>
#include <vug/base/error.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace vug::network {
namespace {

using Json = nlohmann::ordered_json;

/// Calls row(key, value, unit) for the sizes of the network.
template <class Row>
void for_each_size(const Metrics& m, const Row& row) {
  row("stations", m.stations, "");
  row("legs", m.legs, "");
  row("length", m.length, "m");
  row("components", m.components, "");
  row("cycles", m.cycles, "");
  row("nodes", m.nodes, "");
  row("edges", m.edges, "");
}

/// One line for each criterion of a list and its scores, in the same order.
template <class AnyCriterion>
std::string lines(const std::vector<AnyCriterion>& criteria,
                  const std::vector<CriterionScore>& scores) {
  std::string text;
  for (size_t i = 0; i < scores.size(); ++i) {
    const CriterionScore& s = scores[i];
    const RealRange real = range_of(criteria[i]);
    const bool defined = !std::isnan(s.value);
    text += fmt::format(
        "{:<34}  {:>8}  {:>10}  {:>8}  {}\n", label(criteria[i].name, criteria[i].unit),
        defined ? fmt::format("{:.3g}", s.value) : "-",
        defined ? fmt::format("{:.0f} %", 100 * s.percentile) : "-",
        fmt::format("{:.3g}", real.median), fmt::format("{:.3g} to {:.3g}", real.low, real.high));
  }
  return text;
}

std::string column_titles(const char* title) {
  return fmt::format("\n{:<34}  {:>8}  {:>10}  {:>8}  {}\n", title, "value", "percentile", "median",
                     "real caves");
}

Json score_entry(const CriterionScore& s, const char* unit) {
  Json entry = {{"name", s.name},
                {"unit", unit},
                {"value", s.value},
                {"percentile", s.percentile},
                {"realism", s.realism}};
  if (!s.advice.empty()) entry["advice"] = s.advice;
  return entry;
}

Json network_entry(const Criterion& criterion, const CriterionScore& s) {
  Json entry = score_entry(s, criterion.unit);
  for (size_t i = 0; i < kQuantileFractions.size(); ++i)
    entry["real"][fmt::format("p{:.0f}", 100 * kQuantileFractions[i])] = criterion.quantiles[i];
  return entry;
}

Json section_entry(const SectionCriterion& criterion, const CriterionScore& s) {
  Json entry = score_entry(s, criterion.unit);
  const RealRange real = range_of(criterion);
  entry["real"] = {{"lowest", real.lowest},   {"low", real.low},
                   {"median", real.median},   {"high", real.high},
                   {"highest", real.highest}, {"regions", criterion.regions}};
  return entry;
}

}  // namespace

ScoredNetwork scored(const Network& network, const std::string& name) {
  ScoredNetwork cave{name, measure(network), measure_sections(network), {}};
  if (cave.metrics.legs == 0)
    throw Error(ErrorCode::bad_input, fmt::format("the network '{}' has no legs underground", name),
                {}, "a score needs at least one leg that is neither a duplicate nor a splay");
  cave.realism = score(cave.metrics, cave.sections);
  return cave;
}

std::string score_table(const ScoredNetwork& cave) {
  std::string text = fmt::format("{:<12}  {}\n", "network", cave.name);
  for_each_size(cave.metrics, [&](const char* key, auto value, const char* unit) {
    text += fmt::format("{:<12}  {:.6g}{}{}\n", key, static_cast<double>(value), *unit ? " " : "",
                        unit);
  });
  // Rounded down: 100 means that no measure is outside the real caves.
  text +=
      fmt::format("{:<12}  {:.0f} of 100\n", "realism", std::floor(cave.realism.overall + 1e-9));
  text += column_titles("shape of the network") + lines(criteria(), cave.realism.network);
  if (!cave.realism.sections.empty())
    text +=
        column_titles(fmt::format("passages ({} cross-sections)", cave.sections.count).c_str()) +
        lines(section_criteria(), cave.realism.sections);
  if (cave.metrics.edges < kFewestBranches)
    text += fmt::format(
        "\nThe network has fewer than {} branches, so the comparison with whole caves says "
        "little.\n",
        kFewestBranches);
  const std::vector<std::string> advice = cave.realism.advice();
  if (!advice.empty()) text += "\n";
  for (const std::string& sentence : advice) text += sentence + "\n";
  return text;
}

Json score_json(const ScoredNetwork& cave) {
  Json out = {{"name", cave.name}};
  for_each_size(cave.metrics, [&](const char* key, auto value, const char*) { out[key] = value; });
  out["cross_sections"] = cave.sections.count;
  out["overall"] = cave.realism.overall;
  out["network"] = Json::array();
  for (size_t i = 0; i < cave.realism.network.size(); ++i)
    out["network"].push_back(network_entry(criteria()[i], cave.realism.network[i]));
  out["sections"] = Json::array();
  for (size_t i = 0; i < cave.realism.sections.size(); ++i)
    out["sections"].push_back(section_entry(section_criteria()[i], cave.realism.sections[i]));
  out["advice"] = cave.realism.advice();
  return out;
}

}  // namespace vug::network
