// Divided by what both pictures show, not by the reference alone, so that it does not matter which
// of them is called the reference.
#include <vug/image/measure_kind.h>

#include <cmath>

namespace vug::image {
namespace {

MeasureResult relative_rmse(const Comparison& pair) {
  const Differences d = differences(pair);
  if (!(d.squares > 0)) return {};
  return {d.magnitude > 0 ? std::sqrt(d.squares) / d.magnitude : kInfinity, {}};
}

}  // namespace
}  // namespace vug::image

VUG_MEASURE(relative_rmse) {
  return lower_is_better("relative_rmse", "rmse over the mean size of all values of both pictures.",
                         "", relative_rmse);
}
