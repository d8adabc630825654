// Whether what was found in a cloud is a facade at all.
#pragma once

#include <vug/scan/range_image.h>

namespace vug::scan {

struct QualityWarning {
  std::string message, hint;  ///< What speaks against it; what to do.
};

/// Of a strip that is too low for a facade, as a floor leaves it when an upright plane is looked
/// for; and of a plane that has hardly more points than any would have among as many strewn evenly.
std::vector<QualityWarning> quality_warnings(const PointCloud& cloud, const PlaneFit& plane,
                                             const RangeImage& range);

}  // namespace vug::scan
