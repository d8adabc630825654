// SPDX-License-Identifier: Apache-2.0
#include <vug/image/measure_kind.h>

#include <cmath>

namespace vug::image {
namespace {

MeasureResult rmse(const Comparison& pair) { return {std::sqrt(differences(pair).squares), {}}; }

}  // namespace
}  // namespace vug::image

VUG_MEASURE(rmse) {
  return lower_is_better("rmse", "Root mean squared difference of all values.", "", rmse);
}
