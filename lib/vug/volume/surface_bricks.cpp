// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/surface_bricks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace vug::volume {
namespace {

using openvdb::Coord;
using FloatLeaf = openvdb::FloatTree::LeafNodeType;
using SurfaceBrick = SurfaceBricks::Brick;

// These bytes identify the content of an image.
static_assert(std::has_unique_object_representations_v<SurfaceBrick>);
static_assert(FloatLeaf::DIM == SurfaceBricks::kSize);

/// All samples that the gradients of a crossed cell need are within this distance of the surface.
constexpr double kReach = 4;  // Voxels.

int16_t rounded(float value, float units) {
  const float scaled = std::clamp(std::nearbyint(value * units), -32767.0f, 32767.0f);
  return static_cast<int16_t>(value <= 0 ? std::min(scaled, -1.0f) : scaled);
}

SurfaceBrick brick_at(const openvdb::FloatGrid& grid, const Coord& origin, float units) {
  const auto accessor = grid.getConstUnsafeAccessor();
  const FloatLeaf* leaves[27];
  float without[27];
  for (int n = 0; n < 27; ++n) {
    const Coord at =
        origin.offsetBy((n / 9 - 1) * SurfaceBricks::kSize, (n / 3 % 3 - 1) * SurfaceBricks::kSize,
                        (n % 3 - 1) * SurfaceBricks::kSize);
    leaves[n] = accessor.probeConstLeaf(at);
    without[n] = leaves[n] ? 0 : accessor.getValue(at);
  }
  SurfaceBrick brick;
  brick.first = {origin.x(), origin.y(), origin.z()};
  size_t to = 0;
  const auto block = [](int x) { return (x + SurfaceBricks::kSize) / SurfaceBricks::kSize; };
  const auto within = [](int x) {
    return static_cast<unsigned>(x + SurfaceBricks::kSize) % SurfaceBricks::kSize;
  };
  for (int i = -1; i < SurfaceBricks::kSize + 2; ++i)
    for (int j = -1; j < SurfaceBricks::kSize + 2; ++j)
      for (int k = -1; k < SurfaceBricks::kSize + 2; ++k) {
        const int n = block(i) * 9 + block(j) * 3 + block(k);
        const unsigned offset = within(i) * SurfaceBricks::kSize * SurfaceBricks::kSize +
                                within(j) * SurfaceBricks::kSize + within(k);
        brick.values[to++] = rounded(leaves[n] ? leaves[n]->getValue(offset) : without[n], units);
      }
  brick.find_crossed();
  return brick;
}

/// Blocks that can contain a crossed cell: one of its corners lies in a leaf, its first corner
/// in the same or the previous block.
std::vector<Coord> candidates(const openvdb::FloatGrid& grid) {
  std::vector<Coord> all;
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf)
    for (int n = 0; n < 8; ++n)
      all.push_back(leaf->origin().offsetBy(-(n >> 2) * SurfaceBricks::kSize,
                                            -(n >> 1 & 1) * SurfaceBricks::kSize,
                                            -(n & 1) * SurfaceBricks::kSize));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

SurfaceBricks::SurfaceBricks(const LevelSet& level_set, double smallest_piece)
    : voxel_(level_set.voxel()), step_(std::min(level_set.background(), kReach * voxel_) / 32767) {
  const openvdb::FloatGrid& grid = floats(level_set);
  const auto world = [&](const Vec3d& p) {
    const openvdb::Vec3d q = grid.indexToWorld(openvdb::Vec3d(p.x, p.y, p.z));
    return Vec3d(q.x(), q.y(), q.z());
  };
  origin_ = world({0, 0, 0});
  for (int axis = 0; axis < 3; ++axis) {
    Vec3d unit(0.0);
    unit[axis] = 1;
    if (!((world(unit) - origin_ - unit * voxel_).length() < 1e-9 * voxel_))
      throw Error(ErrorCode::bad_input,
                  fmt::format("the axes of level set '{}' are rotated", level_set.name()));
  }
  const auto units = static_cast<float>(1 / step_);
  const std::vector<Coord> blocks = candidates(grid);
  std::vector<uint8_t> crossed(blocks.size());
  parallel_for(
      blocks.size(), [&](size_t i) { crossed[i] = brick_at(grid, blocks[i], units).any_crossed(); },
      16);
  std::vector<Coord> kept;
  for (size_t i = 0; i < blocks.size(); ++i)
    if (crossed[i]) kept.push_back(blocks[i]);
  bricks_.resize(kept.size());
  parallel_for(
      kept.size(), [&](size_t i) { bricks_[i] = brick_at(grid, kept[i], units); }, 16);
  // Removing a crumb may turn its inside into a crumb.
  for (size_t gone = 1; smallest_piece > 0 && gone > 0; components_removed_ += gone)
    gone = flip_small_sets(smallest_piece);
  bricks_.shrink_to_fit();
}

void SurfaceBricks::Brick::find_crossed() {
  mask.fill(0), low.fill(SurfaceBricks::kSize), high.fill(0);
  for (int i = 0; i < SurfaceBricks::kSize; ++i)
    for (int j = 0; j < SurfaceBricks::kSize; ++j) {
      const int row = i * SurfaceBricks::kSize + j;
      for (int k = 0; k < SurfaceBricks::kSize; ++k) {
        int inside = 0;
        for (int corner = 0; corner < 8; ++corner)
          inside += at(i + (corner >> 2), j + (corner >> 1 & 1), k + (corner & 1)) < 0;
        if (inside == 0 || inside == 8) continue;
        mask[static_cast<size_t>(row)] |= static_cast<uint8_t>(1 << k);
        const int cell[] = {i, j, k};
        for (size_t axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], static_cast<uint8_t>(cell[axis]));
          high[axis] = std::max(high[axis], static_cast<uint8_t>(cell[axis] + 1));
        }
      }
    }
}

Box3d SurfaceBricks::box(size_t number) const {
  const SurfaceBrick& brick = bricks_[number];
  Box3d out;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<size_t>(axis);
    out.min[axis] = origin_[axis] + (brick.first[a] + brick.low[a]) * voxel_;
    out.max[axis] = origin_[axis] + (brick.first[a] + brick.high[a]) * voxel_;
  }
  return out;
}

Box3d SurfaceBricks::bounds() const {
  Box3d all;
  for (size_t i = 0; i < bricks_.size(); ++i) all.extendBy(box(i));
  return all;
}

/// On average, a surface of area A meets 1.5 A / edge^2 cubes: see estimate.cpp.
double brick_estimate(double area, double voxel) {
  const double edge = SurfaceBricks::kSize * voxel;
  return 1.5 * area / (edge * edge);
}

}  // namespace vug::volume
