// SPDX-License-Identifier: Apache-2.0
// Krichevsky and Trofimov's adaptive code: pixels n_1 .. n_k of k clusters, n in total, cost
//   -log2 [ G(k/2) / G(n + k/2) * prod G(n_i + 1/2) / G(1/2) ]
// bits, for example log2(128 / 5) for (3, 1).
#include <vug/base/kind.h>
#include <vug/fit/likelihood.h>
#include <vug/inference/bits.h>

namespace vug::fit {
namespace {

/// log2 of G(n + start) / G(start) for n = 0 .. most.
std::vector<double> rising(double start, size_t most) {
  std::vector<double> out(most + 1, 0);
  for (size_t n = 0; n < most; ++n)
    out[n + 1] = out[n] + inference::log2(static_cast<double>(n) + start);
  return out;
}

class Kt : public Likelihood {
 public:
  explicit Kt(const Evidence& evidence)
      : lanes_(static_cast<size_t>(evidence.lanes())),
        half_(rising(0.5, pixels(evidence))),
        all_(rising(0.5 * evidence.lanes(), pixels(evidence))) {}

  double bits(RegionType, const Sums& sums) const override {
    double found = 0;
    size_t all = 0;
    for (size_t i = 0; i < lanes_; ++i) {
      found += half_[sums.lane[i]];
      all += sums.lane[i];
    }
    return all_[all] - found;
  }

 private:
  static size_t pixels(const Evidence& evidence) {
    return static_cast<size_t>(evidence.width()) * static_cast<size_t>(evidence.height());
  }
  size_t lanes_;
  std::vector<double> half_, all_;
};

}  // namespace
}  // namespace vug::fit

VUG_LIKELIHOOD(kt) {
  return {
      {"kt",
       "likelihood",
       "Adaptive code of a region's clusters: regions of few clusters, no matter which, are cheap.",
       "krichevsky1981",
       {}},
      [](const Evidence& evidence) { return std::make_shared<const Kt>(evidence); }};
}
