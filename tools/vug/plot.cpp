// SPDX-License-Identifier: Apache-2.0
#include "plot.h"

#include <fmt/format.h>
#include <vug/base/xml.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::cli {
namespace {

constexpr double kWidth = 640, kPanel = 206, kLeft = 90, kRight = 20, kTop = 40, kGap = 58;

/// A round step (1, 2 or 5 times a power of ten) that divides `span` into about four intervals.
double round_step(double span) {
  const double raw = span > 0 ? span / 4 : 1;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10 * power;
}

struct Axis {
  double low, high, step;
  double fraction(double v) const { return (v - low) / (high - low); }
};

Axis axis_of(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) low = high = 0;
  const double step = round_step(high - low);
  Axis axis{step * std::floor(low / step), step * std::ceil(high / step), step};
  if (axis.high <= axis.low) axis.high = axis.low + step;
  return axis;
}

std::string panel(const Plot& plot, const Curve& curve, double top) {
  const std::vector<double>& x = plot.x;
  const Axis ax = axis_of(x), ay = axis_of(curve.y);
  const double bottom = top + kPanel - kGap, width = kWidth - kLeft - kRight, height = bottom - top;
  std::string out;
  for (double v = ay.low; v <= ay.high + ay.step / 2; v += ay.step) {
    const double y = bottom - height * ay.fraction(v);
    out += fmt::format("<line x1='{}' x2='{}' y1='{:.1f}' y2='{:.1f}' stroke='#ddd'/>", kLeft,
                       kWidth - kRight, y, y);
    out += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{:.6g}</text>\n", kLeft - 6,
                       y + 4, v);
  }
  for (double v = ax.low; v <= ax.high + ax.step / 2; v += ax.step)
    out += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{:.6g}</text>\n",
                       kLeft + width * ax.fraction(v), bottom + 15, v);
  std::string points;
  for (size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(curve.y[i])) continue;
    const double px = kLeft + width * ax.fraction(x[i]),
                 py = bottom - height * ay.fraction(curve.y[i]);
    points += fmt::format("{:.1f},{:.1f} ", px, py);
    out += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='3' fill='#a4501c'/>", px, py);
  }
  if (plot.lines)
    out += fmt::format("<polyline points='{}' fill='none' stroke='#a4501c' stroke-width='1.5'/>\n",
                       points);
  out += fmt::format("<text x='{}' y='{:.1f}' font-weight='bold'>{}</text>", kLeft, top - 8,
                     xml_text(curve.label));
  out += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>\n", kWidth - kRight,
                     bottom + 28, xml_text(plot.x_label));
  return out;
}

}  // namespace

std::string plot_svg(const Plot& plot) {
  const double height = kTop + kPanel * static_cast<double>(plot.curves.size()) + 10;
  std::string out = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{}' height='{}' font-family='sans-serif' "
      "font-size='11'>\n"
      "<rect width='100%' height='100%' fill='white'/>\n<text x='{}' y='20' "
      "font-size='14'>{}</text>\n",
      kWidth, height, kLeft, xml_text(plot.title));
  double top = kTop + 10;
  for (const Curve& curve : plot.curves) {
    out += panel(plot, curve, top);
    top += kPanel;
  }
  return out + "</svg>\n";
}

}  // namespace vug::cli
