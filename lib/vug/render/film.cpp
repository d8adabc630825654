#include <vug/render/film.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

int64_t to_plain(float v) {
  const double most = kMostPlain, step = 1 << kPlainBits;
  return std::llrint(std::clamp(static_cast<double>(v), -most, most) * step);
}

double from_plain(int64_t sum) { return static_cast<double>(sum) / (1 << kPlainBits); }

std::array<float, 3> parts(const Vec3f& v) { return {v.x, v.y, v.z}; }

void add_plain(std::array<int64_t, 3>& sums, const Vec3f& v) {
  const auto part = parts(v);
  for (size_t i = 0; i < 3; ++i) sums[i] += to_plain(part[i]);
}

}  // namespace

const std::vector<std::string>& layer_names() {
  static const std::vector<std::string> names = {
      "R",        "G",        "B",          "A",          "Z",          "N.X",
      "N.Y",      "N.Z",      "P.X",        "P.Y",        "P.Z",        "albedo.R",
      "albedo.G", "albedo.B", "variance.R", "variance.G", "variance.B", "samples"};
  return names;
}

void PixelSum::add(const PathResult& sample, const Camera& camera) {
  const auto radiance = parts(sample.radiance);
  if (!(std::isfinite(radiance[0]) && std::isfinite(radiance[1]) && std::isfinite(radiance[2]))) {
    ++refused;
    return;
  }
  ++samples;
  if (std::max({std::fabs(radiance[0]), std::fabs(radiance[1]), std::fabs(radiance[2])}) >
      static_cast<float>(kMostLight))
    ++cut;
  for (size_t i = 0; i < 3; ++i) {
    const double v = std::clamp(static_cast<double>(radiance[i]), -kMostLight, kMostLight);
    light[i] += to_wide(v, kLightBits);
    square[i] += to_wide(v * v, kSquareBits);
  }
  alpha += to_plain(sample.alpha);
  if (!sample.first.hit) return;
  ++hits;
  add_plain(normal, sample.first.normal);
  add_plain(position, sample.first.position);
  add_plain(albedo, sample.first.albedo);
  depth += to_plain(camera.depth(sample.first.position));
}

void PixelSum::merge(const PixelSum& other) {
  for (size_t i = 0; i < 3; ++i) {
    light[i] += other.light[i], square[i] += other.square[i];
    normal[i] += other.normal[i], position[i] += other.position[i], albedo[i] += other.albedo[i];
  }
  alpha += other.alpha, depth += other.depth;
  samples += other.samples, hits += other.hits;
  refused += other.refused, cut += other.cut;
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

void PixelSum::store(image::Image& image, int x, int y) const {
  const double all = 1.0 / std::max(samples, 1u), hit = 1.0 / std::max(hits, 1u);
  float* out = &image.at(x, y);
  const auto put = [&](double v) { *out++ = static_cast<float>(v); };
  const auto put_plain = [&](const std::array<int64_t, 3>& sums) {
    for (const int64_t sum : sums) put(from_plain(sum) * hit);
  };
  for (size_t i = 0; i < 3; ++i) put(mean(i));
  put(from_plain(alpha) * all);
  put(hits > 0 ? from_plain(depth) * hit : 1e10);
  put_plain(normal);
  put_plain(position);
  put_plain(albedo);
  for (size_t i = 0; i < 3; ++i) put(variance(i));
  put(samples);
}

}  // namespace vug::render
