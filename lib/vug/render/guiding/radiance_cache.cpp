#include <vug/render/guiding/radiance_cache.h>

#include <algorithm>
#include <cmath>

namespace vug::render {
namespace {

constexpr int kBits = 19;
/// Radiance is counted in steps of 2^-32 and cut at 2^16.
constexpr float kStep = 0x1p32f, kMost = 0x1p16f;

/// 0 to 5: the axis that a normal is nearest to, and its side.
uint64_t facing(const Vec3f& n) {
  uint64_t axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(n[i]) > std::fabs(n[static_cast<int>(axis)])) axis = static_cast<uint64_t>(i);
  return 2 * axis + (n[static_cast<int>(axis)] < 0 ? 1 : 0);
}

}  // namespace

RadianceCache::RadianceCache(float cube)
    : per_metre_(1 / cube), cells_(std::make_unique<Cell[]>(size_t{1} << kBits)) {}

size_t RadianceCache::index(const Vec3f& point, const Vec3f& normal) const {
  uint64_t bits = facing(normal);
  for (int axis = 0; axis < 3; ++axis) {
    const auto cube = static_cast<int64_t>(std::floor(point[axis] * per_metre_));
    bits = (bits + static_cast<uint64_t>(cube)) * 0x9e3779b97f4a7c15ull;
    bits ^= bits >> 32;
  }
  return (bits * 0xbf58476d1ce4e5b9ull) >> (64 - kBits);
}

void RadianceCache::record(const Vec3f& point, const Vec3f& normal, float radiance) {
  Cell& cell = cells_[index(point, normal)];
  const float kept = radiance > 0 ? std::min(radiance, kMost) : 0;
  cell.sum.fetch_add(static_cast<int64_t>(kept * kStep), std::memory_order_relaxed);
  cell.count.fetch_add(1, std::memory_order_relaxed);
}

float RadianceCache::radiance(const Vec3f& point, const Vec3f& normal) const {
  const Cell& cell = cells_[index(point, normal)];
  const auto count = cell.count.load(std::memory_order_relaxed);
  if (count == 0) return 0;
  return static_cast<float>(static_cast<double>(cell.sum.load(std::memory_order_relaxed)) /
                            static_cast<double>(count)) /
         kStep;
}

}  // namespace vug::render
