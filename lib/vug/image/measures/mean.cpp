#include <vug/image/measure_kind.h>

namespace vug::image {
namespace {

Measured mean(const Comparison& pair) { return {differences(pair).mean, {}}; }

}  // namespace
}  // namespace vug::image

VUG_MEASURE(mean) {
  return low_is_alike("mean", "Mean difference of all values, without sign.", "", mean);
}
