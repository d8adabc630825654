// Code lengths under each look, from maps that were trained on labelled pictures.
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
  return {{"supervised",
           "likelihood",
           "Sums up how unlikely each pixel is under its region's look, by maps of looks.",
           "",
           {}},
          [](const Evidence& evidence) {
            if (evidence.lanes() != kRegionTypes)
              throw Error(ErrorCode::bad_input,
                          "the supervised likelihood needs a map for each look");
            return std::make_shared<const Supervised>();
          }};
}
