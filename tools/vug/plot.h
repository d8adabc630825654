// Line plots as SVG: what `vug sweep` draws.
#pragma once

#include <string>
#include <vector>

namespace vug::cli {

/// One curve over shared x values; NaN where a value is not known.
struct Curve {
  std::string label;
  std::vector<double> y;
};

struct Plot {
  std::string title;
  std::string x_label;
  std::vector<double> x;
  std::vector<Curve> curves;
  bool lines = true;  ///< Join the points, in the order given.
};

/// One panel for each curve below each other, axes linear, labels at round numbers. The same
/// input gives the same bytes.
std::string plot_svg(const Plot& plot);

}  // namespace vug::cli
