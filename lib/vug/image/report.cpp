// SPDX-License-Identifier: Apache-2.0
#include <vug/image/report.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace vug::image {
namespace {

using Json = nlohmann::ordered_json;

const char* basis_text(const Diff& diff) {
  switch (diff.basis) {
    case Basis::identical:
      return "identical";
    case Basis::limits:
      return diff.tested ? "limits and significance" : "limits";
    case Basis::significance:
      return "significance";
    case Basis::rounding:
      break;
  }
  return "rounding";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

std::string row_text(const LayerResult& row) {
  std::string out = fmt::format("{:<16} {:<14} {:>12.6g}", row.layer, row.measure, row.value);
  if (row.limit) {
    const bool low = measure_of(row.measure).better == Measure::Better::low;
    out += fmt::format("   {} {:<10.6g} {}", low ? "at most " : "at least", *row.limit,
                       row.passed ? "" : "FAILED");
  }
  while (out.back() == ' ') out.pop_back();
  return out + "\n";
}

Json to_json(const Significance& s, bool heeded) {
  Json out{{"different", s.different}, {"heeded", heeded}, {"chance", s.p_value},
           {"bias", number(s.bias)},   {"block", s.block}, {"blocks", s.blocks},
           {"mean_z", s.mean_z},       {"std_z", s.std_z}, {"beyond_3", s.beyond_3}};
  for (const Finding& f : s.findings)
    out["findings"].push_back({{"name", f.name},
                               {"channel", f.channel},
                               {"value", number(f.value)},
                               {"chance", f.p_value},
                               {"different", f.different}});
  return out;
}

std::string to_text(const Significance& s, const std::string& layer) {
  std::string out = fmt::format(
      "\nsignificance of {}, {} blocks of {} x {} pixels: mean z {:.3f}, std z {:.3f}, |z| > 3 in "
      "{:.2f} %, brightness {:+.3f} %\n",
      layer, s.blocks, s.block, s.block, s.mean_z, s.std_z, 100 * s.beyond_3, 100 * s.bias);
  for (const Finding& f : s.findings)
    out += fmt::format("  {:<8} {:>10.4g} in {}   chance {:<10.3g} {}\n", f.name, f.value,
                       f.channel, f.p_value, f.different ? "FAILED" : "");
  return out;
}

}  // namespace

std::string verdict_text(const Diff& diff) {
  if (!diff.same)
    return fmt::format("different: {}",
                       fmt::join(diff.words.empty() ? diff.reasons : diff.words, "; "));
  switch (diff.basis) {
    case Basis::identical:
      return "identical";
    case Basis::limits:
      return diff.tested ? "the same: within the limits and the noise"
                         : "the same: within the limits";
    case Basis::significance:
      return "the same: the differences are within the noise";
    case Basis::rounding:
      break;
  }
  return "the same: the differences are within rounding";
}

std::vector<std::string> remarks(const Diff& diff) {
  std::vector<std::string> out;
  if (diff.not_finite > 0) out.push_back(fmt::format("{} values are not finite", diff.not_finite));
  if (!diff.unjudged.empty())
    out.push_back(
        fmt::format("not judged although they differ: {} (set limits, as in --max {}.rmse=0.01)",
                    fmt::join(diff.unjudged, ", "), diff.unjudged.front()));
  if (!diff.same && diff.basis == Basis::rounding)
    out.emplace_back(
        "the noise is unknown: neither picture contains the variance of its pixels, so every "
        "difference above rounding counts (render with the layer variance, or set limits, as in "
        "--max relative_rmse=0.01)");
  return out;
}

std::string to_table(const Diff& diff) {
  std::string out = verdict_text(diff) + "\n";
  for (const std::string& remark : remarks(diff)) out += remark + "\n";
  out += fmt::format("\n{:<16} {:<14} {:>12}\n", "layer", "measure", "value");
  for (const LayerResult& row : diff.rows) out += row_text(row);
  if (!diff.identical.empty())
    out += fmt::format("\nidentical: {}\n", fmt::join(diff.identical, ", "));
  if (diff.significance) out += to_text(*diff.significance, "the beauty");
  for (const auto& [view, significance] : diff.other_views) out += to_text(significance, view);
  if (!diff.reasons.empty()) out += fmt::format("\nreasons: {}\n", fmt::join(diff.reasons, "; "));
  return out;
}

std::string to_json(const Diff& diff, const std::string& reference, const std::string& test) {
  Json out{{"reference", reference},    {"test", test},
           {"same", diff.same},         {"basis", basis_text(diff)},
           {"words", diff.words},       {"reasons", diff.reasons},
           {"exposure", diff.exposure}, {"not_finite", diff.not_finite},
           {"unjudged", diff.unjudged}, {"identical", diff.identical}};
  out["layers"] = Json::object();
  for (const LayerResult& row : diff.rows) {
    Json& entry = out["layers"][row.layer][row.measure];
    entry["value"] = number(row.value);
    if (row.limit) entry["limit"] = *row.limit, entry["passed"] = row.passed;
  }
  if (diff.significance) out["significance"] = to_json(*diff.significance, diff.tested);
  for (const auto& [view, significance] : diff.other_views)
    out["other_views"][view] = to_json(significance, diff.tested);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Image heat_picture(const Diff& diff) {
  return heat_map(diff.heat, diff.shown.reference.width, diff.shown.reference.height);
}

}  // namespace vug::image
