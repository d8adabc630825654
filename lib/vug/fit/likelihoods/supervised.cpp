// SPDX-License-Identifier: Apache-2.0
// Code lengths under each region type, from the maps of a trained pixel classifier.
#include <vug/base/error.h>
#include <vug/base/kind.h>
#include <vug/fit/likelihood.h>

namespace vug::fit {
namespace {

class Supervised : public Likelihood {
 public:
  double bits(RegionType type, const Sums& sums) const override {
    return kBitStep * sums.lane[static_cast<size_t>(type)];
  }
  bool is_supervised() const override { return true; }
};

}  // namespace
}  // namespace vug::fit

VUG_LIKELIHOOD(supervised) {
  return {
      {"supervised",
       "likelihood",
       "Sums the code lengths of the pixels under their region's type, from a trained classifier.",
       "",
       {}},
      [](const Evidence& evidence) {
        if (evidence.lanes() != kRegionTypes)
          throw Error(ErrorCode::bad_input,
                      "the supervised likelihood needs one lane per region type");
        return std::make_shared<const Supervised>();
      }};
}
