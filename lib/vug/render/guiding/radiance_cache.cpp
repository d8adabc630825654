// SPDX-License-Identifier: Apache-2.0
#include <vug/render/guiding/radiance_cache.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

/// Number of prior samples, with the mean of the whole scene, in each region.
constexpr double kPrior = 0.5;

struct Sum {
  double count = 0, all = 0, square = 0;

  void add(const RadianceSample& s) {
    const auto indirect = static_cast<double>(s.indirect);
    count += 1, all += static_cast<double>(s.luminance), square += indirect * indirect;
  }
  void add(const Sum& other, double weight) {
    const double part = other.count > 0 ? weight / other.count : 0;
    count += part * other.count, all += part * other.all, square += part * other.square;
  }
  float mean() const { return count > 0 ? static_cast<float>(all / count) : 0; }
  float root_mean_square() const {
    return count > 0 ? static_cast<float>(std::sqrt(square / count)) : 0;
  }
};

}  // namespace

RadianceCache::RadianceCache(const std::vector<RadianceSample>& radiance_samples,
                             const Box3f& bounds, float edge)
    : regions_(bounds, edge) {
  Sum whole, first;
  std::vector<Sum> sums(kFacings * regions_.count());
  for (const RadianceSample& s : radiance_samples) {
    whole.add(s);
    if (s.first) first.add(s);
    sums[place(s.point, s.normal)].add(s);
  }
  const float usual = first.mean();
  for (Sum& sum : sums) {
    sum.add(whole, kPrior);
    stats_.push_back({std::min(sum.mean(), usual), sum.root_mean_square()});
  }
  double off = 0;
  for (const RadianceSample& s : radiance_samples) {
    if (!s.first) continue;
    const size_t at = place(s.point, s.normal);
    off += static_cast<double>(std::fabs(s.luminance - sums[at].mean()) / stats_[at].mean);
  }
  off = std::min(1.0, off / first.count);
  noise_ = static_cast<float>(off * off);
}

}  // namespace vug::render
