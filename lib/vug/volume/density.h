// SPDX-License-Identifier: Apache-2.0
// A fog volume's values in plain blocks, for fast lookups along rays.
#pragma once

#include <vug/volume/grid.h>
#include <vug/volume/majorant_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::volume {

/// Trilinear samples of a float grid, or of one component of a vector grid. Space is divided into
/// blocks of 16^3 voxels; blocks whose values are all 0 are not stored. Lookups are limited by
/// memory access, so a value takes 16 bits: one of 65535 steps between the minimum and maximum of
/// its block. Negative values count as 0. Index coordinates are those of the grid minus `origin`;
/// lattice points have integer coordinates. Immutable, thread-safe.
class Density {
 public:
  /// `part`: vector component, 0 to 2. Throws Error(bad_input) for grids of other types and for
  /// values that are not finite.
  explicit Density(const Grid& grid, int part = 0);

  /// Converts from world to index coordinates; directions without the translation.
  Vec3f to_index(const Vec3f& world) const;
  Vec3f direction_to_index(const Vec3f& world) const;
  /// Voxels along each axis: the maximum of index coordinates, which start at 0.
  const Vec3f& size() const { return size_; }
  /// World-space box of all non-zero values.
  const Box3f& bounds() const { return bounds_; }
  /// Bounds of the values in bricks of 8, 16, 32 and 64 voxels; empty if all values are 0.
  const std::vector<MajorantGrid>& majorants() const { return majorants_; }

  /// The interpolated value; 0 outside.
  float at(const Vec3f& index) const;
  /// The value of one of the eight surrounding lattice points, selected by numbers in [0, 1) such
  /// that the mean is the interpolated value, for estimators that are linear in the density. It
  /// needs one memory access instead of eight. The point may lie outside by less than a voxel.
  float stochastic_at(const Vec3f& index, const Vec3f& u) const;
  /// Prefetches the data that `at` will read.
  void prefetch(const Vec3f& index) const;
  /// `at` for world-space points; outside the stored data the background of the grid.
  float at_world(const Vec3f& world) const;
  uint64_t bytes() const;

 private:
  static constexpr int kSize = 16;
  static constexpr int kStride = kSize + 1;  ///< Blocks include the first voxels of the next block.
  using Values = std::array<uint16_t, kStride * kStride * kStride>;
  struct Block {
    float least = 0, step = 0;
    int32_t slot = -1;  ///< Index of its values; -1: none, all values are 0.
  };
  const Block& block(const Vec3i& at) const {
    return blocks_[static_cast<size_t>(at.x) + row_ * static_cast<size_t>(at.y) +
                   plane_ * static_cast<size_t>(at.z)];
  }
  const uint16_t* cell_of(const Block& block, const Vec3i& cell) const {
    const auto in = [&](int axis) { return cell[axis] & (kSize - 1); };
    return values_[static_cast<size_t>(block.slot)].data() + (in(2) * kStride + in(1)) * kStride +
           in(0);
  }
  bool within(const Vec3f& index) const;
  template <class Source, class Value>
  void fill(const Source& grid, const std::string& name, const Value& value_of);

  Mat44d world_to_index_;
  float background_ = 0;
  Vec3f size_{0, 0, 0};
  Box3f bounds_;
  std::vector<MajorantGrid> majorants_;
  size_t row_ = 0, plane_ = 0;
  std::vector<Block>
      blocks_;  ///< In rows of x, then planes, with an empty block at the end of each.
  std::vector<Values> values_;
};

inline float Density::stochastic_at(const Vec3f& p, const Vec3f& u) const {
  const Vec3i cell(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  const Block& b = block(cell / kSize);
  if (b.slot < 0) return 0;
  const auto next = [&](int axis) { return u[axis] < p[axis] - static_cast<float>(cell[axis]); };
  const int corner = next(0) + kStride * (next(1) + kStride * next(2));
  return b.least + b.step * cell_of(b, cell)[corner];
}

}  // namespace vug::volume
