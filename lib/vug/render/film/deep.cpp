// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/deep.h>
#include <vug/render/film/fixed_point.h>

#include <algorithm>
#include <cmath>

namespace vug::render {

void DeepPixel::Fragment::merge(const Fragment& behind) {
  far = std::max(far, behind.far);
  alpha += behind.alpha, r += behind.r, g += behind.g, b += behind.b;
}

void DeepPixel::add(const PathResult& sample, double depth) {
  const Rgb& light = sample.radiance;
  if (!(std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z))) return;
  ++samples_;
  const auto limited = [](float v) {
    return std::clamp(static_cast<double>(v), -kMaxLight, kMaxLight);
  };
  const double depth_or_sky = sample.first.hit ? depth : kDeepSky;
  fragments_.push_back({depth_or_sky, depth_or_sky, static_cast<double>(sample.alpha),
                        limited(light.x), limited(light.y), limited(light.z)});
}

void DeepPixel::merge_nearby() {
  // Equal depths keep the order of the samples, so that sums are rounded deterministically.
  std::stable_sort(fragments_.begin(), fragments_.end(),
                   [](const Fragment& a, const Fragment& b) { return a.near < b.near; });
  std::vector<Fragment> kept;
  for (const Fragment& next : fragments_)
    if (!kept.empty() &&
        next.near - kept.back().near <= options_.tolerance * std::fabs(kept.back().near))
      kept.back().merge(next);
    else
      kept.push_back(next);
  while (kept.size() > std::max<size_t>(options_.max_samples, 1)) {
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
  fragments_ = std::move(kept);
}

std::vector<image::DeepSample> DeepPixel::finish() {
  merge_nearby();
  std::vector<image::DeepSample> out;
  double left = static_cast<double>(std::max<size_t>(samples_, 1));  // not yet covered
  for (const Fragment& f : fragments_) {
    const auto part = [&](double v) { return static_cast<float>(v / left); };
    out.push_back({static_cast<float>(f.near), static_cast<float>(f.far),
                   std::min(1.0f, part(f.alpha)), part(f.r), part(f.g), part(f.b)});
    left -= f.alpha;
    // Nothing is visible behind full coverage: a sample covers at most itself.
    if (!(left > 0)) break;
  }
  fragments_.clear();
  samples_ = 0;
  return out;
}

}  // namespace vug::render
