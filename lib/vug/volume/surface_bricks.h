// SPDX-License-Identifier: Apache-2.0
// The surface of a level set for ray tracing: bricks of samples near the surface instead of a mesh.
#pragma once

#include <vug/base/vec.h>
#include <vug/volume/level_set.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vug::volume {

/// Samples around the zero set of the trilinear interpolant, which is watertight because cells (the
/// cubes between eight lattice points) share their faces. Space is divided into bricks of 8^3
/// cells; bricks that the surface does not cross are not stored. Lattice points have integer
/// lattice coordinates. Immutable, thread-safe.
class SurfaceBricks {
 public:
  /// Removes components whose box has a diagonal below `smallest_piece` metres, both crumbs and
  /// closed bubbles, as mesh::large_components does, except for the largest component and for
  /// components that contain a whole brick. Throws Error(bad_input) for a rotated grid.
  explicit SurfaceBricks(const LevelSet& level_set, double smallest_piece = 0);

  static constexpr int kSize = 8;  ///< Cells along the edge of a brick.

  /// A brick stores one sample before its first cell and two after its last, so that gradients need
  /// no other brick.
  struct Brick {
    static constexpr int kStride = kSize + 3;
    std::array<int32_t, 3> first;             ///< Lattice point of the first cell's first corner.
    std::array<uint8_t, 3> low, high;         ///< Range of the crossed cells: low <= cell < high.
    std::array<uint8_t, kSize * kSize> mask;  ///< One bit per cell, set if the surface crosses it.
    std::array<int16_t, kStride * kStride * kStride> values;  ///< In units of `step()`.

    /// Indices relative to the first cell's first corner: -1 to 9.
    double at(int i, int j, int k) const {
      const int place = ((i + 1) * kStride + j + 1) * kStride + k + 1;
      return values[static_cast<size_t>(place)];
    }
    bool crossed(int i, int j, int k) const {
      const int row = i * kSize + j;
      return mask[static_cast<size_t>(row)] >> k & 1;
    }
    bool any_crossed() const { return high[0] > 0; }
    void find_crossed();  ///< Computes `mask`, `low` and `high` from the values.
  };
  const std::vector<Brick>& bricks() const { return bricks_; }

  double voxel() const { return voxel_; }  ///< Metres between lattice points.
  /// Metres per unit of the stored values: 2^-13 of a voxel or less. Rounding preserves the sign.
  double step() const { return step_; }
  Vec3d to_lattice(const Vec3d& world) const { return (world - origin_) * (1 / voxel_); }
  /// World-space box of the crossed cells of a brick.
  Box3d box(size_t brick) const;
  Box3d bounds() const;
  uint64_t bytes() const { return bricks_.size() * sizeof(Brick); }
  size_t components_removed() const { return components_removed_; }

 private:
  size_t flip_small_sets(double smallest);

  double voxel_, step_;
  Vec3d origin_;
  std::vector<Brick> bricks_;
  size_t components_removed_ = 0;
};
using SurfaceBricksPtr = std::shared_ptr<const SurfaceBricks>;

/// Approximate number of bricks for a surface of this area.
double brick_estimate(double area, double voxel);

}  // namespace vug::volume
