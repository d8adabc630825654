// SPDX-License-Identifier: Apache-2.0
// Removes small components from a surface without a mesh. Lattice points on one side of the surface
// that are neighbours along an axis are connected; small sets change sides, so that the remaining
// surface is still watertight.
#include <vug/base/disjoint_sets.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/surface_bricks.h>

#include <algorithm>
#include <unordered_map>

namespace vug::volume {
namespace {

using SurfaceBrick = SurfaceBricks::Brick;
using GridPoint = std::array<int, 3>;
constexpr uint32_t kPoints = SurfaceBricks::kSize * SurfaceBricks::kSize * SurfaceBricks::kSize;
constexpr uint32_t kNone = ~0u;

uint32_t within(const GridPoint& p) {
  return static_cast<uint32_t>((p[0] * SurfaceBricks::kSize + p[1]) * SurfaceBricks::kSize + p[2]);
}

template <class Visit>
void each_point(int from, int to, const Visit& visit) {
  for (int i = from; i < to; ++i)
    for (int j = from; j < to; ++j)
      for (int k = from; k < to; ++k) visit(GridPoint{i, j, k});
}

/// Finds bricks by position; they are sorted by it.
class BrickFinder {
 public:
  explicit BrickFinder(const std::vector<SurfaceBrick>& bricks) : bricks_(bricks) {}
  uint32_t brick(const std::array<int32_t, 3>& first) const {
    const auto found =
        std::lower_bound(bricks_.begin(), bricks_.end(), first,
                         [](const SurfaceBrick& brick, const std::array<int32_t, 3>& at) {
                           return brick.first < at;
                         });
    if (found == bricks_.end() || found->first != first) return kNone;
    return static_cast<uint32_t>(found - bricks_.begin());
  }
  /// The bricks around a brick, with itself in the middle; by x, y, z.
  std::array<uint32_t, 27> around(const SurfaceBrick& brick) const {
    std::array<uint32_t, 27> out;
    for (int n = 0; n < 27; ++n)
      out[static_cast<size_t>(n)] =
          this->brick({brick.first[0] + (n / 9 - 1) * SurfaceBricks::kSize,
                       brick.first[1] + (n / 3 % 3 - 1) * SurfaceBricks::kSize,
                       brick.first[2] + (n % 3 - 1) * SurfaceBricks::kSize});
    return out;
  }

 private:
  const std::vector<SurfaceBrick>& bricks_;
};

/// The surrounding brick that contains a point, and its index there.
struct Owner {
  size_t which;
  GridPoint point;

  explicit Owner(const GridPoint& p) {
    size_t n = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      n = n * 3 + static_cast<size_t>((p[axis] + SurfaceBricks::kSize) / SurfaceBricks::kSize);
      point[axis] = (p[axis] + SurfaceBricks::kSize) % SurfaceBricks::kSize;
    }
    which = n;
  }
};

/// A connected set of lattice points on one side.
struct Set {
  Box3d box;
  bool inside = false;
  bool open = false;  ///< It extends to where no bricks are, so it is not small.
};

}  // namespace

/// Sets that contain all points of a block without a brick are never small enough.
size_t SurfaceBricks::flip_small_sets(double smallest) {
  if (bricks_.size() >= kNone / kPoints)
    throw Error(
        ErrorCode::too_large,
        "a surface with this number of voxels is too large for the removal of small components", {},
        "omit 'smallest_piece', or use a larger voxel");
  const BrickFinder finder(bricks_);
  DisjointSets<> sets(bricks_.size() * kPoints);
  std::vector<uint32_t> open;
  for (uint32_t b = 0; b < bricks_.size(); ++b) {
    const SurfaceBrick& brick = bricks_[b];
    const auto around = finder.around(brick);
    const auto inside = [&](const GridPoint& p) { return brick.at(p[0], p[1], p[2]) < 0; };
    each_point(0, SurfaceBricks::kSize, [&](const GridPoint& p) {
      const uint32_t own = b * kPoints + within(p);
      for (size_t axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          GridPoint next = p;
          next[axis] += step;
          if (inside(p) != inside(next)) continue;
          const Owner owner(next);
          if (around[owner.which] == kNone)
            open.push_back(own);
          else if (step > 0)
            sets.join(own, around[owner.which] * kPoints + within(owner.point));
        }
    });
  }
  std::unordered_map<uint32_t, Set> all;
  for (uint32_t b = 0; b < bricks_.size(); ++b)
    each_point(0, SurfaceBricks::kSize, [&](const GridPoint& p) {
      Set& set = all[sets.root(b * kPoints + within(p))];
      const SurfaceBrick& brick = bricks_[b];
      set.inside = brick.at(p[0], p[1], p[2]) < 0;
      set.box.extendBy(Vec3d(brick.first[0] + p[0], brick.first[1] + p[1], brick.first[2] + p[2]));
    });
  for (const uint32_t point : open) all[sets.root(point)].open = true;

  // On average, the surface is half a voxel beyond the points.
  const auto size = [&](const Set& set) {
    return set.open ? kInfinity : (set.box.size() + Vec3d(1)).length() * voxel_;
  };
  double largest[2] = {0, 0};
  for (const auto& [root, set] : all)
    largest[set.inside] = std::max(largest[set.inside], size(set));
  std::vector<uint8_t> goes(bricks_.size() * kPoints);
  size_t count = 0;
  for (const auto& [root, set] : all)
    if (size(set) < smallest && size(set) < largest[set.inside]) goes[root] = 1, ++count;
  if (count == 0) return 0;
  for (uint32_t i = 0; i < goes.size(); ++i) goes[i] = goes[sets.root(i)];
  parallel_for(
      bricks_.size(),
      [&](size_t b) {
        SurfaceBrick& brick = bricks_[b];
        const auto around = finder.around(brick);
        size_t value = 0;
        each_point(-1, SurfaceBricks::kSize + 2, [&](const GridPoint& p) {
          const Owner owner(p);
          const uint32_t in = around[owner.which];
          int16_t& here = brick.values[value++];
          if (in != kNone && goes[in * kPoints + within(owner.point)])
            here = static_cast<int16_t>(here < 0 ? -here : std::min(-here, -1));
        });
        brick.find_crossed();
      },
      16);
  bricks_.erase(std::remove_if(bricks_.begin(), bricks_.end(),
                               [](const SurfaceBrick& brick) { return !brick.any_crossed(); }),
                bricks_.end());
  return count;
}

}  // namespace vug::volume
