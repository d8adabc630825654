#include <vug/image/measure_kind.h>

#include <cmath>

namespace vug::image {
namespace {

Measured rmse(const Comparison& pair) { return {std::sqrt(differences(pair).squares), {}}; }

}  // namespace
}  // namespace vug::image

VUG_MEASURE(rmse) {
  return low_is_alike("rmse", "Root of the mean squared difference of all values.", "", rmse);
}
