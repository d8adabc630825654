// Line plots as SVG: what `vug sweep` draws.
#pragma once

#include <string>
#include <vector>

namespace vug::cli {

/// One curve over shared x values.
struct Curve {
  std::string label;
  std::vector<double> y;
};

/// One panel for each curve below each other, axes linear, labels at round numbers. The same
/// input gives the same bytes.
std::string plot_svg(const std::string& title, const std::string& x_label,
                     const std::vector<double>& x, const std::vector<Curve>& curves);

}  // namespace vug::cli
