// SPDX-License-Identifier: Apache-2.0
// Output of reports as JSON and SVG.
#include <vug/fit/report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

using Json = nlohmann::ordered_json;

/// At most `most` values, evenly spaced.
inference::Trace thinned(const inference::Trace& trace, size_t most) {
  const size_t step = trace.size() / most + 1;
  inference::Trace out;
  for (size_t i = 0; i < trace.size(); i += step) out.push_back(trace[i]);
  return out;
}

/// JSON has no representation for non-finite numbers, so they become null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// One panel of the drawing: a frame with a title and its contents.
class Panel {
 public:
  Panel(double x, double y, double width, double height, const std::string& title)
      : width_(width), height_(height) {
    out_ = fmt::format(
        "<g transform=\"translate({:.0f} {:.0f})\">\n<text y=\"-8\" class=\"t\">{}</text>\n"
        "<rect width=\"{:.0f}\" height=\"{:.0f}\" class=\"f\"/>\n",
        x, y, title, width, height);
  }
  void bar(double x, double y, double width, double height, const char* colour,
           const std::string& tip) {
    out_ += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\">"
        "<title>{}</title></rect>\n",
        x, y, width, height, colour, tip);
  }
  void text(double x, double y, const std::string& text, const char* anchor = "start") {
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                        anchor, text);
  }
  void line(const std::vector<std::pair<double, double>>& points, const char* colour) {
    out_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\" points=\"", colour);
    for (const auto& [x, y] : points) out_ += fmt::format("{:.1f},{:.1f} ", x, y);
    out_ += "\"/>\n";
  }
  double width() const { return width_; }
  double height() const { return height_; }
  std::string done() const { return out_ + "</g>\n"; }

 private:
  double width_, height_;
  std::string out_;
};

constexpr const char* kColours[] = {"#1f5f99", "#c4572a", "#3f8f4f", "#8a4fa3"};

std::string traces_panel(const Report& report) {
  Panel panel(70, 50, 800, 200, "bits of the coldest chain of each run, after warming up");
  double low = 1e300, high = -1e300;
  size_t longest = 1;
  for (const inference::Trace& trace : report.traces) {
    longest = std::max(longest, trace.size());
    for (const double bits : trace) low = std::min(low, bits), high = std::max(high, bits);
  }
  if (low > high) return panel.done();
  const double range = std::max(high - low, 1e-9);
  for (size_t run = 0; run < report.traces.size(); ++run) {
    std::vector<std::pair<double, double>> points;
    const inference::Trace trace = thinned(report.traces[run], 800);
    for (size_t i = 0; i < trace.size(); ++i)
      points.emplace_back(panel.width() * static_cast<double>(i) /
                              std::max(1.0, static_cast<double>(trace.size()) - 1),
                          panel.height() * (0.95 - 0.9 * (trace[i] - low) / range));
    panel.line(points, kColours[run % std::size(kColours)]);
  }
  panel.text(-6, 0.95 * panel.height() + 4, fmt::format("{:.1f}", low), "end");
  panel.text(-6, 0.05 * panel.height() + 4, fmt::format("{:.1f}", high), "end");
  panel.text(0, panel.height() + 16,
             fmt::format("{} rounds; R-hat {:.3f}, effective size {:.0f}, Geweke z {:.1f}", longest,
                         report.scale_reduction, report.effective_size, report.geweke));
  return panel.done();
}

std::string swaps_panel(const Report& report) {
  Panel panel(70, 320, 380, 150, "exchanges of neighbours; 20 to 60 % is well");
  const size_t count = report.temperatures.size();
  const double step = panel.width() / static_cast<double>(std::max<size_t>(1, count));
  panel.bar(0, 0.4 * panel.height(), panel.width(), 0.4 * panel.height(), "#e8f1e8", "20 to 60 %");
  for (size_t i = 0; i < report.swap_rates.size(); ++i) {
    const double rate = report.swap_rates[i];
    panel.bar((static_cast<double>(i) + 0.65) * step, panel.height() * (1 - rate), 0.7 * step,
              panel.height() * rate, kColours[0], fmt::format("{:.0f} %", 100 * rate));
  }
  for (size_t i = 0; i < count; ++i)
    panel.text((static_cast<double>(i) + 0.5) * step, panel.height() + 16,
               fmt::format("{:.3g}", report.temperatures[i]), "middle");
  panel.text(0, panel.height() + 32, "temperatures");
  return panel.done();
}

std::string posterior_panel(const Report& report) {
  Panel panel(490, 320, 380, 150, "structures, by how often the coldest chains were in them");
  constexpr size_t kMax = 7;
  for (size_t i = 0; i < std::min(kMax, report.posterior.size()); ++i) {
    const StructureProbability& one = report.posterior[i];
    const double y = 6 + 20 * static_cast<double>(i);
    panel.bar(0, y, panel.width() * one.probability, 14, "#cfe0ef", one.structure);
    std::string name = one.structure.substr(0, 44);
    if (name.size() < one.structure.size()) name += "...";
    panel.text(4, y + 11,
               fmt::format("{:.1f} ± {:.1f} %  {}", 100 * one.probability, 100 * one.standard_error,
                           name));
  }
  return panel.done();
}

std::string moves_panel(const Report& report) {
  const double height = 18 * static_cast<double>(report.moves.size()) + 8;
  Panel panel(170, 550, 700, height, "moves: possible (light) and accepted (dark) of those tried");
  for (size_t i = 0; i < report.moves.size(); ++i) {
    const inference::MoveCount& count = report.moves[i].count;
    const double y = 6 + 18 * static_cast<double>(i);
    const double tried = std::max(1.0, static_cast<double>(count.tried));
    const double possible = static_cast<double>(count.possible) / tried,
                 accepted = static_cast<double>(count.accepted) / tried;
    panel.bar(0, y, panel.width() * possible, 12, "#cfe0ef", fmt::format("{}", count.possible));
    panel.bar(0, y, panel.width() * accepted, 12, kColours[0], fmt::format("{}", count.accepted));
    panel.text(-8, y + 10, report.moves[i].name, "end");
    panel.text(panel.width() - 4, y + 10,
               fmt::format("{:.2f} % of {}", 100 * accepted, count.tried), "end");
  }
  return panel.done();
}

}  // namespace

std::string report_json(const Report& report) {
  Json out;
  out["structure"] = report.structure;
  out["bits"] = {{"all", report.bits},
                 {"tree", report.complexity},
                 {"wall", report.wall_bits},
                 {"seed", report.seed_bits},
                 {"chains", report.chain_bits}};
  out["score"] = {{"s", report.score},
                  {"complexity", report.complexity},
                  {"most_complexity", report.max_complexity},
                  {"misfit", report.misfit}};
  out["posterior"] = Json::array();
  for (const StructureProbability& one : report.posterior)
    out["posterior"].push_back({{"structure", one.structure},
                                {"share", one.probability},
                                {"error", number(one.standard_error)}});
  out["convergence"] = {{"effective_size", number(report.effective_size)},
                        {"scale_reduction", number(report.scale_reduction)},
                        {"elements_scale_reduction", number(report.elements_scale_reduction)},
                        {"geweke", number(report.geweke)},
                        {"stopped", report.stopped}};
  out["warnings"] = Json::array();
  if (const auto warning = disagreement(report))
    out["warnings"].push_back({{"message", warning->message}, {"hint", warning->hint}});
  out["temperatures"] = report.temperatures;
  out["swap_rates"] = report.swap_rates;
  out["moves"] = Json::array();
  for (const MoveRate& move : report.moves)
    out["moves"].push_back({{"name", move.name},
                            {"tried", move.count.tried},
                            {"possible", move.count.possible},
                            {"accepted", move.count.accepted}});
  out["traces"] = Json::array();
  for (const inference::Trace& trace : report.traces) out["traces"].push_back(thinned(trace, 1000));
  return out.dump(1) + "\n";
}

std::string report_svg(const Report& report) {
  std::string warning;
  if (const auto found = disagreement(report))
    warning = fmt::format(
        "<text x=\"70\" y=\"286\" style=\"fill:#b00020\">{}</text>\n"
        "<text x=\"70\" y=\"300\" style=\"fill:#b00020\">{}</text>\n",
        found->message, found->hint);
  const int height = 600 + 18 * static_cast<int>(report.moves.size());
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"920\" height=\"{0}\" viewBox=\"0 0 "
             "920 {0}\">\n<style>text{{font:11px sans-serif;fill:#333}}.t{{font-weight:bold;"
             "font-size:12px}}.f{{fill:#fafafa;stroke:#bbb}}</style>\n<rect width=\"920\" "
             "height=\"{0}\" fill=\"white\"/>\n<text x=\"70\" y=\"22\" class=\"t\">s(T) {1:.4f}; "
             "{2:.1f} bits, of these {3:.1f} for the tree{4}</text>\n",
             height, report.score, report.bits, report.complexity,
             report.stopped ? "; stopped early" : "") +
         warning + traces_panel(report) + swaps_panel(report) + posterior_panel(report) +
         moves_panel(report) + "</svg>\n";
}

}  // namespace vug::fit
