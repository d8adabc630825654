// SPDX-License-Identifier: Apache-2.0
// No stone floats: a flood fill of the solid voxels of three decorated chambers.
#include <vug/field/boolean.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/thickened.h>
#include <vug/volume/dense.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "decorated_chambers.h"

namespace vug::drips {
namespace {

/// Solid voxels that touch, also by a corner, are one body.
struct Body {
  size_t voxels = 0;
  Vec3i first{0, 0, 0};  ///< One of its voxels.
};

/// Sets of numbers; the lowest number of each is its root.
class Sets {
 public:
  int add() {
    parents_.push_back(static_cast<int>(parents_.size()));
    return parents_.back();
  }
  int root(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& parent(int i) { return parents_[static_cast<size_t>(i)]; }
  std::vector<int> parents_;
};

/// Fills the solid of a level set, one plane of voxels after the other.
class Flood {
 public:
  Flood(const Vec3i& from, const Vec3i& to)
      : from_(from), to_(to), ny_(to.y - from.y + 1), nz_(to.z - from.z + 1) {}

  std::vector<Body> bodies(const volume::LevelSet& solid) {
    std::vector<float> values(index(ny_, 0));
    plane_.assign(values.size(), -1);
    for (int i = from_.x; i <= to_.x; ++i) {
      volume::copy_dense(solid, {i, from_.y, from_.z}, {i, to_.y, to_.z}, values.data());
      before_ = std::move(plane_);
      plane_.assign(values.size(), -1);
      for (int j = 0; j < ny_; ++j)
        for (int k = 0; k < nz_; ++k)
          if (values[index(j, k)] <= 0) fill(i, j, k);
    }
    std::vector<Body> out(parts_.size());
    for (size_t n = 0; n < parts_.size(); ++n) {
      Body& body = out[static_cast<size_t>(sets_.root(static_cast<int>(n)))];
      if (body.voxels == 0) body.first = parts_[n].first;
      body.voxels += parts_[n].voxels;
    }
    std::erase_if(out, [](const Body& body) { return body.voxels == 0; });
    return out;
  }

 private:
  size_t index(int j, int k) const {
    return static_cast<size_t>(j) * static_cast<size_t>(nz_) + static_cast<size_t>(k);
  }

  void touch(const std::vector<int>& labels, int j, int k, int& label) {
    if (j < 0 || j >= ny_ || k < 0 || k >= nz_) return;
    const int other = labels[index(j, k)];
    if (other < 0 || other == label) return;
    if (label < 0)
      label = other;
    else
      sets_.join(label, other);
  }

  /// Joins a voxel with those of its 13 neighbours that have been visited.
  void fill(int i, int j, int k) {
    int label = -1;
    touch(plane_, j, k - 1, label);
    // Its predecessor in the row has touched the other neighbours already.
    for (int dk = label < 0 ? -1 : 1; dk <= 1; ++dk) {
      touch(plane_, j - 1, k + dk, label);
      for (int dj = -1; dj <= 1; ++dj) touch(before_, j + dj, k + dk, label);
    }
    if (label < 0) {
      label = sets_.add();
      parts_.push_back({0, {i, from_.y + j, from_.z + k}});
    }
    plane_[index(j, k)] = label;
    ++parts_[static_cast<size_t>(label)].voxels;
  }

  Vec3i from_, to_;
  int ny_, nz_;
  std::vector<int> plane_, before_;
  Sets sets_;
  std::vector<Body> parts_;
};

Vec3i nearest_cell(const Vec3d& p, double voxel) {
  return {static_cast<int>(std::lround(p.x / voxel)), static_cast<int>(std::lround(p.y / voxel)),
          static_cast<int>(std::lround(p.z / voxel))};
}

class Floating : public testing::TestWithParam<Style> {};

TEST_P(Floating, TheChamberWithAllThatGrewIsOneBody) {
  const DripstoneOptions o = options_of(GetParam());
  const field::Field rock = rock_of(o);
  const Dripstone grown = grow_dripstone(rock, build_graph(rock, o.graph), o);
  ASSERT_GT(grown.forms.size(), 150u);
  const double voxel = GetParam().voxel, half = 1.1 * o.graph.to.x + 0.3;
  const field::Field thick = field::thickened(rock, grown.thickness, field::kThickestDeposit);
  const field::Field solid =
      field::unite({thick, grown.solids}, field::Blend{field::Profile::smooth, 0.1 + voxel});
  volume::VoxelizeOptions options;
  options.voxel = voxel;
  // The walls are part of it, so that floor and roof are connected without any column.
  options.region = Box3d({-half, -2.4, -half}, {half, 2.4, half});
  Flood flood(nearest_cell(options.region->min, voxel), nearest_cell(options.region->max, voxel));
  int chambers = 0;
  for (const Body& body : flood.bodies(volume::voxelize(solid, options))) {
    if (body.voxels > 1000000) {
      ++chambers;
      continue;
    }
    const Vec3d at = Vec3d(body.first.x, body.first.y, body.first.z) * voxel;
    // A ridge of the rough rock may be thinner than a voxel; meshes omit such crumbs.
    EXPECT_TRUE(body.voxels <= 2 && rock.value(at) < 0)
        << body.voxels << " voxels float at " << at.x << " " << at.y << " " << at.z;
  }
  EXPECT_EQ(chambers, 1);
}

INSTANTIATE_TEST_SUITE_P(Styles, Floating, testing::ValuesIn(kStyles),
                         [](const auto& style) { return std::string(style.param.name); });

}  // namespace
}  // namespace vug::drips
