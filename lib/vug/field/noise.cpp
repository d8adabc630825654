// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/field/noise.h>

namespace vug::field {

Noise make_noise(const std::string& kind, const NamedValues& params) {
  return make_product(noises(), kind, params);
}

std::optional<Noise> default_noise(const std::string& kind) {
  const NoiseKind* found = find_kind(noises(), kind);
  if (!found) return std::nullopt;
  Diagnostics diagnostics;
  return found->make({}, {}, diagnostics);
}

Noise::Noise() : Noise(*default_noise(kDefaultNoise)) { is_default = true; }

namespace {

constexpr size_t kPacks = 64, kChunk = kPacks * Pack::kLanes;

}  // namespace

void sample(const Field& field, std::span<const Vec3f> points, std::span<float> out) {
  thread_local Scratch scratch;
  Point<Pack> in[kPacks];
  Pack values[kPacks];
  for (size_t first = 0; first < points.size(); first += kChunk) {
    const size_t count = std::min(kChunk, points.size() - first);
    const size_t packs = (count + Pack::kLanes - 1) / Pack::kLanes;
    for (size_t k = 0; k < packs; ++k) {
      float lanes[3][Pack::kLanes];
      for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
        const Vec3f& p = points[first + std::min(k * Pack::kLanes + lane, count - 1)];
        for (int axis = 0; axis < 3; ++axis) lanes[axis][lane] = p[axis];
      }
      in[k] = {Pack::load(lanes[0]), Pack::load(lanes[1]), Pack::load(lanes[2])};
    }
    field.values(in, static_cast<int>(packs), values, scratch);
    for (size_t k = 0; k < packs; ++k) {
      float lanes[Pack::kLanes];
      values[k].store(lanes);
      for (size_t lane = 0; lane < Pack::kLanes && k * Pack::kLanes + lane < count; ++lane)
        out[first + k * Pack::kLanes + lane] = lanes[lane];
    }
  }
}

std::vector<float> sample(const Field& field, const std::vector<Vec3f>& points) {
  std::vector<float> out(points.size());
  parallel_for((points.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    const size_t first = chunk * kChunk, count = std::min(kChunk, points.size() - first);
    sample(field, std::span(points).subspan(first, count), std::span(out).subspan(first, count));
  });
  return out;
}

}  // namespace vug::field
