// SPDX-License-Identifier: Apache-2.0
#include <vug/render/guiding/visibility_cache.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Number of prior samples, with the mean over all regions, in each region.
constexpr float kVisibilityPrior = 2;

}  // namespace

VisibilityCache::VisibilityCache(const Box3f& bounds, float edge, size_t targets,
                                 const std::vector<VisibilitySample>& visibility_samples)
    : regions_(bounds, edge), targets_(targets) {
  row_of_.assign(regions_.count(), 0);
  std::vector<float> reached(targets, 0), tried(targets, 0);
  for (const VisibilitySample& sample : visibility_samples) {
    uint32_t& row = row_of_[regions_.at(sample.position)];
    if (row == 0) {
      row = static_cast<uint32_t>(reached.size() / targets);
      reached.resize(reached.size() + targets, 0), tried.resize(tried.size() + targets, 0);
    }
    for (const size_t at : {size_t{sample.target}, row * targets + sample.target}) {
      tried[at] += 1;
      reached[at] += sample.visible ? 1.0f : 0.0f;
    }
  }
  roots_.resize(reached.size());
  for (size_t target = 0; target < targets; ++target) {
    const float usual = (reached[target] + 1) / (tried[target] + 2);
    roots_[target] = std::sqrt(usual);
    for (size_t at = targets + target; at < roots_.size(); at += targets)
      roots_[at] =
          std::sqrt((reached[at] + kVisibilityPrior * usual) / (tried[at] + kVisibilityPrior));
  }
}

bool VisibilityCache::is_consistent() const {
  if (empty()) return true;
  const size_t rows = roots_.size() / targets_;
  return row_of_.size() == regions_.count() && roots_.size() == rows * targets_ &&
         std::all_of(row_of_.begin(), row_of_.end(), [&](uint32_t row) { return row < rows; });
}

}  // namespace vug::render
