// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/film.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

std::array<float, 3> parts(const Vec3f& v) { return {v.x, v.y, v.z}; }

double limited(float light) {
  return std::clamp(static_cast<double>(light), -kMaxLight, kMaxLight);
}

void add_plain(std::array<int64_t, 3>& sums, const Vec3f& v) {
  const auto part = parts(v);
  for (size_t i = 0; i < 3; ++i) sums[i] += to_plain(part[i]);
}

void add_coverage(Coverage& list, uint32_t object, uint32_t samples) {
  auto entry = std::lower_bound(list.begin(), list.end(), std::pair(object, 0u));
  if (entry == list.end() || entry->first != object) entry = list.insert(entry, {object, 0});
  entry->second += samples;
}

DeepFragment fragment_of(uint32_t index, const PathResult& sample, const Camera& camera) {
  const auto light = parts(sample.radiance);
  const auto channel = [&](size_t i) { return static_cast<float>(limited(light[i])); };
  const float depth =
      sample.first.hit ? camera.depth_at(sample.time, sample.first.position) : kDeepSky;
  return {index, depth, sample.alpha, channel(0), channel(1), channel(2)};
}

/// Inserts the fragments of other samples. Allocates exactly the memory that is needed.
void add_fragments(std::vector<DeepFragment>& list, const std::vector<DeepFragment>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(list.size());
  list.reserve(list.size() + more.size());
  list.insert(list.end(), more.begin(), more.end());
  std::inplace_merge(
      list.begin(), list.begin() + middle, list.end(),
      [](const DeepFragment& a, const DeepFragment& b) { return a.sample < b.sample; });
}

}  // namespace

bool PixelSum::add(const PathResult& sample, const Camera& camera) {
  const auto radiance = parts(sample.radiance);
  if (!(std::isfinite(radiance[0]) && std::isfinite(radiance[1]) && std::isfinite(radiance[2]))) {
    ++invalid;
    return false;
  }
  ++samples;
  if (std::max({std::fabs(radiance[0]), std::fabs(radiance[1]), std::fabs(radiance[2])}) >
      static_cast<float>(kMaxLight))
    ++clamped;
  for (size_t i = 0; i < 3; ++i) {
    const double v = limited(radiance[i]);
    light[i] += to_wide(v, kLightBits);
    square[i] += to_wide(v * v, kSquareBits);
  }
  alpha += to_plain(sample.alpha);
  if (!sample.first.hit) return true;
  ++hits;
  add_plain(normal, sample.first.normal);
  add_plain(position, sample.first.position);
  add_plain(albedo, sample.first.albedo);
  depth += to_plain(camera.depth_at(sample.time, sample.first.position));
  return true;
}

void PixelSum::merge(const PixelSum& other) {
  for (size_t i = 0; i < 3; ++i) {
    light[i] += other.light[i], square[i] += other.square[i];
    normal[i] += other.normal[i], position[i] += other.position[i], albedo[i] += other.albedo[i];
  }
  alpha += other.alpha, depth += other.depth;
  samples += other.samples, hits += other.hits;
  invalid += other.invalid, clamped += other.clamped;
}

double PixelSum::mean(size_t channel) const {
  return from_wide(light[channel], kLightBits) / std::max(samples, 1u);
}

double PixelSum::variance(size_t channel) const {
  if (samples < 2) return 0;
  const double n = samples, m = mean(channel);
  const double spread = from_wide(square[channel], kSquareBits) / n - m * m;
  return std::max(0.0, spread) / (n - 1);
}

Film::Film(const Region& region, const FilmLayout& layout)
    : region_(region),
      layout_(layout),
      sums_(region.pixels()),
      colours_(region.pixels() * layout.colours * 3),
      coverage_(layout.coverage ? region.pixels() : 0),
      fragments_(layout.deep ? region.pixels() : 0) {}

void Film::add(int x, int y, uint32_t index, const PathResult& sample, const Camera& camera,
               const Rgb* values) {
  if (!at(x, y).add(sample, camera)) return;
  Wide* to = colours(x, y);
  for (size_t i = 0; i < layout_.colours; ++i)
    for (const float v : parts(values[i]))
      *to++ += std::isfinite(v) ? to_wide(limited(v), kLightBits) : 0;
  if (layout_.coverage && sample.first.hit) add_coverage(coverage(x, y), sample.first.object, 1);
  if (layout_.deep) fragments(x, y).push_back(fragment_of(index, sample, camera));
}

void Film::merge(const Film& other) {
  const Region both = region_.overlap(other.region_);
  for (int y = both.y0; y < both.y1; ++y)
    for (int x = both.x0; x < both.x1; ++x) {
      at(x, y).merge(other.at(x, y));
      const Wide* from = other.colours(x, y);
      Wide* to = colours(x, y);
      for (size_t i = 0; i < layout_.colours * 3; ++i) to[i] += from[i];
      if (layout_.coverage)
        for (const auto& [object, samples] : other.coverage(x, y))
          add_coverage(coverage(x, y), object, samples);
      if (layout_.deep) add_fragments(fragments(x, y), other.fragments(x, y));
    }
}

std::pair<uint64_t, uint64_t> Film::invalid_samples() const {
  std::pair<uint64_t, uint64_t> all;
  for (const PixelSum& sum : sums_) all.first += sum.invalid, all.second += sum.clamped;
  return all;
}

double Film::pixel_bytes(const FilmLayout& layout, double samples) {
  return sizeof(PixelSum) + 3.0 * sizeof(Wide) * static_cast<double>(layout.colours) +
         (layout.coverage ? sizeof(Coverage) : 0) +
         (layout.deep ? sizeof(std::vector<DeepFragment>) + sizeof(DeepFragment) * samples : 0);
}

}  // namespace vug::render
