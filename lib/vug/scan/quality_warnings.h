// SPDX-License-Identifier: Apache-2.0
// Plausibility checks of a fitted plane: is it a facade?
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

struct QualityWarning {
  std::string message, hint;  ///< The finding, and a remedy.
};

/// Warns about a strip too low for a facade, as a floor produces when an upright plane is fitted,
/// and about a plane with hardly more points than a uniform distribution of as many points would
/// give.
std::vector<QualityWarning> quality_warnings(const PointCloud& cloud, const PlaneFit& plane,
                                             const RangeImage& range);

}  // namespace vug::scan
