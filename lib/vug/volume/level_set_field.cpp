// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/volume/io.h>
#include <vug/volume/level_set_field.h>
#include <vug/volume/openvdb_values.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::volume {
namespace {

using Tree = openvdb::FloatTree;
using openvdb::Coord;

/// The slope of the interpolant is at most the norm of its largest differences along the axes.
double steepest(const openvdb::FloatGrid& grid, double voxel) {
  std::vector<const Tree::LeafNodeType*> leaves;
  grid.tree().getNodes(leaves);
  const auto larger = [](const Vec3f& a, const Vec3f& b) {
    return Vec3f(std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z));
  };
  const auto in_leaf = [&](size_t n) {
    const auto at = grid.getConstUnsafeAccessor();
    Vec3f most(0.0f);
    for (auto voxel_at = leaves[n]->cbeginValueOn(); voxel_at; ++voxel_at)
      for (const int side : {-1, 1})
        for (int axis = 0; axis < 3; ++axis) {
          Coord next = voxel_at.getCoord();
          next[static_cast<size_t>(axis)] += side;
          most[axis] = std::max(most[axis], std::fabs(at.getValue(next) - *voxel_at));
        }
    return most;
  };
  const Vec3f steps = ordered_reduce(leaves.size(), Vec3f(0.0f), in_leaf, larger, 16);
  return std::max(1.0, Vec3d(steps).length() / voxel);
}

class Samples final : public field::SampledGrid {
 public:
  explicit Samples(const LevelSet& level_set)
      : level_set_(level_set),
        bounds_(level_set.statistics().bounds),
        lipschitz_(steepest(floats(level_set), level_set.voxel())) {}

  field::Gradient sample(const Vec3d& p) const override {
    const openvdb::FloatGrid& grid = floats(level_set_);
    const openvdb::Vec3d index = grid.worldToIndex(openvdb::Vec3d(p.x, p.y, p.z));
    const Coord base = Coord::floor(index);
    const double u = index.x() - base.x(), v = index.y() - base.y(), w = index.z() - base.z();
    const auto at = grid.getConstUnsafeAccessor();
    double c[2][2][2];
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          c[i][j][k] = static_cast<double>(at.getValue(base.offsetBy(i, j, k)));
    const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
    // Interpolates along z first, which leaves the values and slopes of four edges.
    double edge[2][2], rise[2][2];
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        edge[i][j] = mix(c[i][j][0], c[i][j][1], w);
        rise[i][j] = c[i][j][1] - c[i][j][0];
      }
    const double low = mix(edge[0][0], edge[0][1], v), high = mix(edge[1][0], edge[1][1], v);
    const double inverse = 1 / level_set_.voxel();
    return {mix(low, high, u),
            Vec3d(high - low, mix(edge[0][1] - edge[0][0], edge[1][1] - edge[1][0], u),
                  mix(mix(rise[0][0], rise[0][1], v), mix(rise[1][0], rise[1][1], v), u)) *
                inverse};
  }
  Box3d bounds() const override { return bounds_; }
  double band() const override { return level_set_.background(); }
  double lipschitz() const override { return lipschitz_; }
  Digest digest() const override { return level_set_.content(); }

 private:
  LevelSet level_set_;
  Box3d bounds_;
  double lipschitz_;
};

}  // namespace

std::shared_ptr<const field::SampledGrid> sampled_grid(const LevelSet& level_set) {
  return std::make_shared<Samples>(level_set);
}

void install_grid_loader() {
  static const bool installed = [] {
    field::set_grid_loader([](const std::string& file, const std::string& name) {
      return sampled_grid(LevelSet(read_grid(file, name)));
    });
    return true;
  }();
  static_cast<void>(installed);
}

}  // namespace vug::volume
