// The surface of a level set for rays: no mesh, only the samples around it, in plain bricks.
#pragma once

#include <vug/base/vec.h>
#include <vug/volume/level_set.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vug::volume {

/// Samples around the zero set of the trilinear interpolant, which is watertight: cells (the cubes
/// between eight lattice points) share their faces. Space is cut into bricks of 8^3 cells; those
/// that the surface does not cross are not stored. Lattice coordinates: lattice points have whole
/// numbers. Immutable, thread-safe.
class SurfaceBricks {
 public:
  /// Crumbs and closed bubbles whose box has a diagonal below `smallest_piece` metres are left out,
  /// as mesh::large_components does, but for the largest, and for those so large that a whole brick
  /// fits in. Error(bad_input) for a grid that is turned.
  explicit SurfaceBricks(const LevelSet& level_set, double smallest_piece = 0);

  static constexpr int kSize = 8;  ///< Cells along a brick.

  /// Every brick holds a sample before its first cell and two behind its last, so that gradients
  /// need no other brick.
  struct Brick {
    static constexpr int kStride = kSize + 3;
    std::array<int32_t, 3> first;             ///< Lattice point of the first cell's first corner.
    std::array<uint8_t, 3> low, high;         ///< Cells that are crossed: low <= cell < high.
    std::array<uint8_t, kSize * kSize> mask;  ///< A bit for each cell that the surface crosses.
    std::array<int16_t, kStride * kStride * kStride> values;  ///< In units of `step()`.

    /// Counted from the first cell's first corner: -1 to 9.
    double at(int i, int j, int k) const {
      const int place = ((i + 1) * kStride + j + 1) * kStride + k + 1;
      return values[static_cast<size_t>(place)];
    }
    bool crossed(int i, int j, int k) const {
      const int row = i * kSize + j;
      return mask[static_cast<size_t>(row)] >> k & 1;
    }
    bool any_crossed() const { return high[0] > 0; }
    void find_crossed();  ///< Sets `mask`, `low` and `high` by the values.
  };
  const std::vector<Brick>& bricks() const { return bricks_; }

  double voxel() const { return voxel_; }  ///< Metres between lattice points.
  /// Metres for a value of 1: 2^-13 of a voxel or less. Rounding keeps the sign.
  double step() const { return step_; }
  Vec3d to_lattice(const Vec3d& world) const { return (world - origin_) * (1 / voxel_); }
  /// World box of the crossed cells of a brick.
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

/// Bricks of a surface of that area, about.
double brick_estimate(double area, double voxel);

}  // namespace vug::volume
