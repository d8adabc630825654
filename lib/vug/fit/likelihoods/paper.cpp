// SPDX-License-Identifier: Apache-2.0
// The published data term: log2(clusters) bits for each pixel outside of the region's main cluster.
// With colour alone it hardly separates windows from walls (docs/explanation/theory/facades.md).
#include <vug/base/kind.h>
#include <vug/fit/likelihood.h>
#include <vug/inference/bits.h>

#include <algorithm>

namespace vug::fit {
namespace {

class Paper : public Likelihood {
 public:
  explicit Paper(const Evidence& evidence)
      : lanes_(static_cast<size_t>(evidence.lanes())), bits_(inference::log2(evidence.lanes())) {}

  double bits(RegionType, const Sums& sums) const override {
    uint32_t all = 0, main = 0;
    for (size_t i = 0; i < lanes_; ++i) {
      all += sums.lane[i];
      main = std::max(main, sums.lane[i]);
    }
    return static_cast<double>(all - main) * bits_;
  }

 private:
  size_t lanes_;
  double bits_;
};

}  // namespace
}  // namespace vug::fit

VUG_LIKELIHOOD(paper) {
  return {{"paper",
           "likelihood",
           "Counts the pixels that differ from a region's main cluster, as published.",
           "ripperda2009",
           {}},
          [](const Evidence& evidence) { return std::make_shared<const Paper>(evidence); }};
}
