// SPDX-License-Identifier: Apache-2.0
#include "fit_summary.h"

#include <vug/base/pluralize.h>

#include <fmt/format.h>

#include <map>

namespace vug::cli {
namespace {

/// "24 windows, 1 door"; walls are not counted.
std::string elements_text(const facade::Tree& tree) {
  std::map<std::string, size_t> counts;
  for (const facade::ElementInstance& one : facade::element_instances(tree))
    ++counts[tree.nodes[static_cast<size_t>(one.node)].element->kind()];
  counts.erase("wall");
  std::string out;
  for (const auto& [kind, count] : counts)
    out += (out.empty() ? "" : ", ") + pluralize(count, kind);
  return out.empty() ? "a bare wall" : out;
}

std::string agreement_text(const fit::Report& report) {
  if (report.stopped) return "the fit was stopped";
  if (fit::disagreement(report)) return "see the warning";
  return fmt::format("the chains agree (R-hat {:.2f})", report.scale_reduction);
}

}  // namespace

std::string fit_summary(const session::FacadeFit& fit, bool assumed_size,
                        const std::vector<NamedFile>& files) {
  const fit::Report& report = fit.reading.report;
  std::string out = fmt::format(
      "facade    {:.4g} x {:.4g} m{}\nelements  {}\nfit       {:.1f} bits, of these "
      "{:.1f} for the tree; {}\n",
      fit.tree.width, fit.tree.height, assumed_size ? " (assumed size)" : "",
      elements_text(fit.tree), report.bits, report.complexity, agreement_text(report));
  if (fit.reveal > 0) out += fmt::format("reveal    {:.2f} m, from the depth\n", fit.reveal);
  for (const NamedFile& each : files)
    if (std::filesystem::exists(each.file))
      out += fmt::format("{:<9} {}\n", each.content, each.file.string());
  return out;
}

}  // namespace vug::cli
