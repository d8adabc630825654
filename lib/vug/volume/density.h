// A fog's values in plain bricks, for fast lookups along rays.
#pragma once

#include <vug/base/vec.h>
#include <vug/volume/grid.h>

#include <array>
#include <vector>

namespace vug::volume {

/// Trilinear samples of a grid of floats, or of one part of a grid of vectors. Space is cut into
/// bricks of 8^3 voxels; those with nothing but 0 in reach are not stored. Values below 0 count as
/// 0. Index coordinates are those of the grid minus `origin`; lattice points have whole numbers.
/// Immutable, thread-safe.
class Density {
 public:
  /// `part`: of a vector, 0 to 2. Error(bad_input): neither floats nor vectors of floats, or values
  /// that are not finite.
  explicit Density(const Grid& grid, int part = 0);

  static constexpr int kSize = 8;  ///< Voxels along a brick.

  /// World to index coordinates; directions without the shift.
  Vec3f to_index(const Vec3f& world) const;
  Vec3f direction_to_index(const Vec3f& world) const;
  /// Bricks along each axis: index coordinates from 0 to kSize times that.
  const Vec3i& bricks() const { return bricks_; }
  /// Box in world space of all that is not 0.
  const Box3f& bounds() const { return bounds_; }

  /// Bounds of all values in a brick.
  struct Range {
    float least = 0, most = 0;
  };
  Range range(const Vec3i& brick) const {
    const int32_t slot = slot_of(brick);
    return slot < 0 ? Range{} : ranges_[static_cast<size_t>(slot)];
  }
  /// The interpolated value; 0 outside.
  float at(const Vec3f& index) const;
  /// The same in world space; outside what the grid holds where nothing was stored.
  float anywhere(const Vec3f& world) const;
  uint64_t bytes() const;

 private:
  static constexpr int kStride = kSize + 1;  ///< Bricks hold the first voxels of the next.
  using Brick = std::array<float, kStride * kStride * kStride>;
  int32_t slot_of(const Vec3i& b) const {
    if (b.x < 0 || b.y < 0 || b.z < 0 || b.x >= bricks_.x || b.y >= bricks_.y || b.z >= bricks_.z)
      return -1;
    return slots_[(static_cast<size_t>(b.z) * static_cast<size_t>(bricks_.y) +
                   static_cast<size_t>(b.y)) *
                      static_cast<size_t>(bricks_.x) +
                  static_cast<size_t>(b.x)];
  }

  template <class Source, class Value>
  void fill(const Source& grid, const std::string& name, const Value& value_of);

  Mat44d world_to_index_;
  float background_ = 0;
  Vec3i bricks_{0, 0, 0};
  Box3f bounds_;
  std::vector<int32_t> slots_;
  std::vector<Range> ranges_;
  std::vector<Brick> values_;
};

}  // namespace vug::volume
