// SPDX-License-Identifier: Apache-2.0
#include <vug/network/score_plot.h>

#include <fmt/format.h>
#include <vug/base/maths.h>
#include <vug/base/xml.h>

#include <algorithm>
#include <cmath>

namespace vug::network {
namespace {

// All lengths in user units.
constexpr double kWidth = 880, kMargin = 40;
constexpr double kHeader = 124, kRow = 38, kSection = 52, kAdvice = 21, kFooter = 44;
constexpr double kAxisLeft = 292, kAxisRight = 682, kValue = 764, kRank = kWidth - kMargin;
constexpr double kBeyond = 0.06;    ///< Axis beyond the extremes, as a fraction of its length.
constexpr double kLogarithmic = 8;  ///< Ratio of the extremes from which an axis is logarithmic.
constexpr double kGood = 80;        ///< Scores above it have the colour of values in the band.

constexpr const char* kStyle =
    "svg{background:#fbfaf6}text{font-family:'Helvetica Neue',Helvetica,Arial,sans-serif;"
    "font-size:13px;fill:#26343b}"
    ".title{font-size:22px;font-weight:600}.note{font-size:12px;fill:#75838a}"
    ".score{font-size:46px;font-weight:600}.section{font-size:12px;font-weight:600;"
    "letter-spacing:1px;fill:#75838a}.tick{font-size:10px;fill:#8d999f;text-anchor:middle}"
    ".right{text-anchor:end}.strong{font-weight:600}"
    ".extent{fill:#e7eae5}.band{fill:#a9cdc5}.median{fill:#2d6e66}.region{fill:#6fa39b}"
    ".in{fill:#14505a}.out{fill:#c4492a}.mark{stroke:#fbfaf6;stroke-width:2}"
    ".rule{stroke:#dcdfda;stroke-width:1}";

/// A criterion as the drawing shows it.
struct Row {
  std::string label;
  RealRange real;
  std::vector<double> regions;
  const CriterionScore* score;
};

template <class AnyCriterion>
Row row_of(const AnyCriterion& criterion, const CriterionScore& score) {
  return {label(criterion.name, criterion.unit), range_of(criterion), {}, &score};
}

/// The horizontal axis of a row.
class Axis {
 public:
  explicit Axis(const RealRange& real)
      : logarithmic_(real.lowest > 0 && real.highest > kLogarithmic * real.lowest),
        low_(transformed(real.lowest)),
        span_(transformed(real.highest) - low_) {}

  /// The position of a value from 0 to 1; below 0 or above 1 beyond the axis.
  double fraction(double value) const {
    if (logarithmic_ && !(value > 0)) return -1;
    return kBeyond + (1 - 2 * kBeyond) * (transformed(value) - low_) / span_;
  }
  double x(double value) const {
    return kAxisLeft + (kAxisRight - kAxisLeft) * std::clamp(fraction(value), 0.0, 1.0);
  }

 private:
  double transformed(double value) const { return logarithmic_ ? maths::log(value) : value; }

  bool logarithmic_;
  double low_, span_;
};

std::string text(double x, double y, const char* style, const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\">{}</text>\n", x, y, style,
                     xml_text(content));
}

std::string bar(double from, double to, double y, double height, const char* style) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"{:.1f}\" "
      "class=\"{}\"/>\n",
      from, y - height / 2, to - from, height, std::min(height, to - from) / 2, style);
}

/// A disc at the value, or a triangle that points out of the axis.
std::string mark(const Axis& axis, double value, double y, const char* style) {
  const double f = axis.fraction(value), x = axis.x(value);
  if (f >= 0 && f <= 1)
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" class=\"{} mark\"/>\n", x, y,
                       style);
  const double tip = f < 0 ? -9 : 9;
  return fmt::format("<path d=\"M{:.1f} {:.1f}l{:.1f} -8v16z\" class=\"{} mark\"/>\n", x + tip, y,
                     -1.6 * tip, style);
}

std::string draw(const Row& row, double y) {
  const CriterionScore& s = *row.score;
  const RealRange& real = row.real;
  const Axis axis(real);
  std::string out = text(kMargin, y + 4.5, "label", row.label);
  out += bar(axis.x(real.lowest), axis.x(real.highest), y, 4, "extent");
  out += bar(axis.x(real.low), axis.x(real.high), y, 14, "band");
  for (const double region : row.regions)
    out += bar(axis.x(region) - 0.75, axis.x(region) + 0.75, y, 14, "region");
  out += bar(axis.x(real.median) - 1.5, axis.x(real.median) + 1.5, y, 18, "median");
  out += text(axis.x(real.low), y + 20, "tick", fmt::format("{:.3g}", real.low));
  out += text(axis.x(real.high), y + 20, "tick", fmt::format("{:.3g}", real.high));
  if (std::isnan(s.value)) return out + text(kValue, y + 4.5, "note right", "undefined");
  const char* style = s.advice.empty() ? "in" : "out";
  out += mark(axis, s.value, y, style);
  out += text(kValue, y + 4.5, fmt::format("{} right strong", style).c_str(),
              fmt::format("{:.3g}", s.value));
  return out + text(kRank, y + 4.5, "right", fmt::format("{:.0f} %", 100 * s.percentile));
}

std::string heading(double y, const std::string& title) {
  return text(kMargin, y, "section", title) + text(kValue, y, "note right", "value") +
         text(kRank, y, "note right", "percentile") +
         fmt::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" class=\"rule\"/>\n",
                     kMargin, kRank, y + 9);
}

std::string header(const ScoredNetwork& cave) {
  const Metrics& m = cave.metrics;
  std::string out = text(kMargin, 52, "title", cave.name);
  out += text(kMargin, 76, "note",
              fmt::format("{} legs, {:.3g} km, {} {} in the reduced graph", m.legs, m.length / 1000,
                          m.nodes, m.nodes == 1 ? "node" : "nodes"));
  const double y = 98;
  out +=
      bar(kMargin, kMargin + 34, y, 4, "extent") + text(kMargin + 42, y + 4, "note", "all caves");
  out += bar(146, 180, y, 14, "band") + text(188, y + 4, "note", "10 % to 90 %, or four regions");
  out += bar(386, 389, y, 18, "median") + text(397, y + 4, "note", "median");
  out += fmt::format("<circle cx=\"465\" cy=\"{:.1f}\" r=\"7\" class=\"in mark\"/>\n", y);
  out += fmt::format("<circle cx=\"479\" cy=\"{:.1f}\" r=\"7\" class=\"out mark\"/>\n", y);
  out += text(492, y + 4, "note", "this cave, in or out of the band");
  const char* style = cave.realism.overall >= kGood ? "score right in" : "score right out";
  out += text(kRank, 72, style, fmt::format("{:.0f}", cave.realism.overall));
  return out + text(kRank, 92, "note right", "realism, of 100");
}

}  // namespace

std::string score_svg(const ScoredNetwork& cave) {
  const Realism& realism = cave.realism;
  std::string rows;
  double y = kHeader;
  const auto section = [&](const std::string& title, const std::vector<Row>& list) {
    rows += heading(y + 26, title);
    y += kSection;
    for (const Row& row : list) {
      rows += draw(row, y + kRow / 2);
      y += kRow;
    }
  };
  std::vector<Row> list;
  for (size_t i = 0; i < realism.network.size(); ++i)
    list.push_back(row_of(criteria()[i], realism.network[i]));
  section("SHAPE OF THE NETWORK", list);
  list.clear();
  for (size_t i = 0; i < realism.sections.size(); ++i) {
    list.push_back(row_of(section_criteria()[i], realism.sections[i]));
    list.back().regions = section_criteria()[i].regions;
  }
  if (!list.empty()) section("PASSAGES", list);
  const std::vector<std::string> advice = realism.advice();
  if (!advice.empty()) rows += text(kMargin, y + 30, "section", "CHANGE");
  if (!advice.empty()) y += 34;
  for (const std::string& sentence : advice) {
    y += kAdvice;
    rows += fmt::format("<circle cx=\"{}\" cy=\"{:.1f}\" r=\"3\" class=\"out\"/>\n", kMargin + 4,
                        y - 4.5);
    rows += text(kMargin + 16, y, "label", sentence);
  }
  y += kFooter;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" "
             "height=\"{1:.0f}\">\n<title>{2}: realism {3:.0f} of 100</title>\n<style>{4}</style>\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"#fbfaf6\"/>\n",
             kWidth, y, xml_text(cave.name), realism.overall, kStyle) +
         header(cave) + rows + "</svg>\n";
}

}  // namespace vug::network
