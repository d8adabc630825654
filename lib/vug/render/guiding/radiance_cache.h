// About how bright a scene's surfaces are, gathered from paths.
#pragma once

#include <vug/render/vectors.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace vug::render {

/// Luminance that leaves surfaces, averaged over cubes of space and six ways to face. Cubes that
/// share a place in the table are averaged together: seldom, and it only makes a guide less sharp.
/// `record` may be called by many threads at once; sums are integers, so the bits are the same.
class RadianceCache {
 public:
  /// `cube`: the length of their edges in metres, > 0.
  explicit RadianceCache(float cube);

  void record(const Vec3f& point, const Vec3f& normal, float radiance);
  /// 0 where nothing was recorded.
  float radiance(const Vec3f& point, const Vec3f& normal) const;

 private:
  struct Cell {
    std::atomic<int64_t> sum{0};
    std::atomic<int64_t> count{0};
  };
  size_t index(const Vec3f& point, const Vec3f& normal) const;

  float per_metre_;
  std::unique_ptr<Cell[]> cells_;
};

}  // namespace vug::render
