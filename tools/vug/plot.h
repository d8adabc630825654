// SPDX-License-Identifier: Apache-2.0
// Line plots as SVG, for `vug sweep`.
#pragma once

#include <string>
#include <vector>

namespace vug::cli {

/// One curve over shared x values; NaN marks an unknown value.
struct Curve {
  std::string label;
  std::vector<double> y;
};

/// A plot of several curves, each in a panel of its own.
struct Plot {
  std::string title;
  std::string x_label;
  std::vector<double> x;
  std::vector<Curve> curves;
  bool lines = true;  ///< Whether the points are joined, in the given order.
};

/// Draws one panel per curve, stacked vertically, with linear axes and labels at round numbers. The
/// same input gives the same bytes.
std::string plot_svg(const Plot& plot);

}  // namespace vug::cli
