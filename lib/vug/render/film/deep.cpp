// SPDX-License-Identifier: Apache-2.0
#include <vug/base/vec.h>
#include <vug/render/film/deep.h>
#include <vug/render/film/film.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

/// A range of depths with the sums of its fragments.
struct DepthRange {
  double near = 0, far = 0, alpha = 0, r = 0, g = 0, b = 0;

  explicit DepthRange(const DeepFragment& f)
      : near(static_cast<double>(f.depth)),
        far(near),
        alpha(static_cast<double>(f.alpha)),
        r(static_cast<double>(f.r)),
        g(static_cast<double>(f.g)),
        b(static_cast<double>(f.b)) {}
  void merge(const DepthRange& behind) {
    far = std::max(far, behind.far);
    alpha += behind.alpha, r += behind.r, g += behind.g, b += behind.b;
  }
};

/// Sorts the ranges by depth and merges those that are close.
std::vector<DepthRange> merge_nearby(std::vector<DepthRange> ranges, const DeepOptions& options) {
  // Equal depths keep the order of the samples, so that sums are rounded deterministically.
  std::stable_sort(ranges.begin(), ranges.end(),
                   [](const DepthRange& a, const DepthRange& b) { return a.near < b.near; });
  std::vector<DepthRange> kept;
  for (const DepthRange& next : ranges)
    if (!kept.empty() &&
        next.near - kept.back().near <= options.tolerance * std::fabs(kept.back().near))
      kept.back().merge(next);
    else
      kept.push_back(next);
  while (kept.size() > std::max<size_t>(options.max_samples, 1)) {
    size_t nearest = 0;
    double least = kInfinity;
    for (size_t i = 0; i + 1 < kept.size(); ++i) {
      // The tolerance that would have merged these two.
      const double gap = (kept[i + 1].far - kept[i].near) / std::max(std::fabs(kept[i].near), 1e-9);
      if (gap < least) least = gap, nearest = i;
    }
    kept[nearest].merge(kept[nearest + 1]);
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(nearest) + 1);
  }
  return kept;
}

}  // namespace

std::vector<image::DeepSample> merge_fragments(std::span<const DeepFragment> fragments,
                                               const DeepOptions& options) {
  const std::vector<DepthRange> ranges =
      merge_nearby(std::vector<DepthRange>(fragments.begin(), fragments.end()), options);
  std::vector<image::DeepSample> out;
  double left = static_cast<double>(std::max<size_t>(fragments.size(), 1));  // not yet covered
  for (const DepthRange& range : ranges) {
    const auto part = [&](double v) { return static_cast<float>(v / left); };
    out.push_back({static_cast<float>(range.near), static_cast<float>(range.far),
                   std::min(1.0f, part(range.alpha)), part(range.r), part(range.g), part(range.b)});
    left -= range.alpha;
    // Nothing is visible behind full coverage: a sample covers at most itself.
    if (!(left > 0)) break;
  }
  return out;
}

void develop(const Film& film, const DeepOptions& options, const Region& origin,
             image::DeepImage& picture) {
  const Region& region = film.region();
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      picture.at(x - origin.x0, y - origin.y0) = merge_fragments(film.fragments(x, y), options);
}

}  // namespace vug::render
