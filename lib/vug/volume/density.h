// A fog's values in plain bricks, for fast lookups along rays.
#pragma once

#include <vug/base/vec.h>
#include <vug/volume/grid.h>

#include <array>
#include <vector>

namespace vug::volume {

/// Trilinear samples of a grid of floats, or of one part of a grid of vectors. Space is cut into
/// bricks of 8^3 voxels; of those with nothing but 0 in reach no values are stored. Values below 0
/// count as 0. Index coordinates are those of the grid minus `origin`; lattice points have whole
/// numbers. Immutable, thread-safe.
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
  const Vec3f& size() const { return size_; }
  /// Box in world space of all that is not 0.
  const Box3f& bounds() const { return bounds_; }

  /// Bounds of all values in a brick, and about their mean.
  struct Range {
    float least = 0, mean = 0, most = 0;
  };
  /// Bricks lie in rows of x, those in planes, with a rim of empty bricks about all.
  size_t brick_index(const Vec3i& brick) const {
    return static_cast<size_t>(brick.x + 1) + row_ * static_cast<size_t>(brick.y + 1) +
           plane_ * static_cast<size_t>(brick.z + 1);
  }
  size_t row() const { return row_; }
  size_t plane() const { return plane_; }
  const Range& range(size_t brick_index) const { return ranges_[brick_index]; }

  /// The interpolated value; 0 outside.
  float at(const Vec3f& index) const;
  /// The same in world space; outside what the grid holds where nothing was stored.
  float anywhere(const Vec3f& world) const;
  uint64_t bytes() const;

 private:
  static constexpr int kStride = kSize + 1;  ///< Bricks hold the first voxels of the next.
  using Brick = std::array<float, kStride * kStride * kStride>;
  template <class Source, class Value>
  void fill(const Source& grid, const std::string& name, const Value& value_of);

  Mat44d world_to_index_;
  float background_ = 0;
  Vec3i bricks_{0, 0, 0};
  Vec3f size_{0, 0, 0};  ///< In voxels.
  Box3f bounds_;
  size_t row_ = 0, plane_ = 0;
  std::vector<int32_t> slots_;  ///< By brick_index; where in `values_`, or -1.
  std::vector<Range> ranges_;   ///< By brick_index.
  std::vector<Brick> values_;
};

}  // namespace vug::volume
