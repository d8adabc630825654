// SPDX-License-Identifier: Apache-2.0
// Bubbles and handles that sampling makes where tubes meet at sharp angles.
#include "../scan/external_data.h"
#include "solids.h"

#include <vug/base/error.h>
#include <vug/mesh/topology.h>
#include <vug/volume/small_features.h>

#include <gtest/gtest.h>

#include <fstream>

namespace vug::meshing {
namespace {

field::Field tube(const Vec3d& a, const Vec3d& b, double radius) {
  return field::make("capsule", {{"radius", radius}, {"a", a}, {"b", b}});
}

/// The Euler characteristic of the mesh, unpolished, which has the same connectivity.
int64_t euler(const volume::LevelSet& level_set) {
  PolygonizeOptions options;
  options.polish = false;
  const mesh::Topology topology = mesh::inspect(polygonize(level_set, nullptr, options).mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.components, 1U);
  return 2 * static_cast<int64_t>(topology.components) -
         2 * static_cast<int64_t>(topology.genus.value());
}

/// Evenly distributed positions of the solid against the lattice, in voxels.
Vec3d placement(int n) {
  return {std::fmod(n * 0.7548776662, 1.0), std::fmod(n * 0.5698402910, 1.0),
          std::fmod(n * 0.3247179572, 1.0)};
}

/// Expects this Euler characteristic in 25 placements, and returns the number of small features.
template <class Solid>
size_t expect_euler(const Solid& solid, double voxel, int64_t expected) {
  size_t removed = 0;
  for (int n = 0; n < 25; ++n) {
    SCOPED_TRACE(testing::Message() << "placement " << n);
    const field::Field field = solid(placement(n) * voxel);
    volume::VoxelizeOptions options;
    options.voxel = voxel;
    const volume::LevelSet level_set = volume::voxelize(field, options);
    const auto small = volume::find_small_features(level_set, &field);
    removed += small.size();
    EXPECT_EQ(euler(volume::without_features(level_set, small)), expected);
  }
  return removed;
}

TEST(SmallTopology, TubesThatMeetAtSharpAnglesAreOneBall) {
  size_t removed = 0;
  for (const double degrees : {23.0, 31.0, 47.0, 63.0}) {
    SCOPED_TRACE(degrees);
    const auto fork = [&](const Vec3d& at) {
      const Transform turned = Transform::rotation({1, 2, 3}, 0.7);
      const double half = 0.5 * degrees * kPi / 180;
      const Vec3d side(6 * std::sin(half), 6 * std::cos(half), 0);
      const Vec3d left = turned.point(side), right = turned.point({-side.x, side.y, 0});
      return field::unite({tube(at, at + left, 1), tube(at, at + right, 1),
                           tube(at, at + turned.point({0, -3, 0.4}), 1)});
    };
    removed += expect_euler(fork, 0.3, 2);
  }
  EXPECT_GT(removed, 3U);
}

/// The nodes and links of a cave network as tubes.
struct Network {
  std::vector<Vec3d> nodes;
  std::vector<std::pair<size_t, size_t>> links;

  Network(const std::filesystem::path& folder, const std::string& name) {
    std::ifstream points(folder / (name + "_nodes.dat")), pairs(folder / (name + "_links.dat"));
    for (Vec3d p; points >> p.x >> p.y >> p.z;) nodes.push_back(p);
    for (size_t a = 0, b = 0; pairs >> a >> b;) links.emplace_back(a - 1, b - 1);
  }
  field::Field tubes(double radius, const Vec3d& by) const {
    std::vector<field::Field> all;
    const Vec3d origin = nodes.at(0);
    for (const auto& [a, b] : links)
      all.push_back(tube(nodes.at(a) - origin + by, nodes.at(b) - origin + by, radius));
    return field::unite(all);
  }
};

TEST(SmallTopology, CaveNetworksHaveTheirEulerNumbers) {
  const std::filesystem::path folder = external_data() / "surveys" / "karst";
  if (external_data().empty() || !std::filesystem::is_directory(folder))
    GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with surveys/karst";
  struct Case {
    const char* name;
    double radius;
    int64_t euler;
  };
  for (const Case& each :
       {Case{"Huttes", 0.5, 0}, {"gorge", 5, 2}, {"permeability", 5, 2}, {"superimposed", 5, -6}}) {
    SCOPED_TRACE(each.name);
    const Network network(folder, each.name);
    expect_euler([&](const Vec3d& by) { return network.tubes(each.radius, by); }, each.radius / 3,
                 each.euler);
  }
}

TEST(SmallTopology, LargerFeaturesKeepTheirBytes) {
  // Bars of one voxel around holes of three, a wire one voxel thick, and a bubble of three voxels.
  std::vector<field::Field> parts;
  for (int i = -2; i <= 2; ++i) {
    parts.push_back(tube({-2, 0.4 * i, 0}, {2, 0.4 * i, 0}, 0.055));
    parts.push_back(tube({0.4 * i, -2, 0}, {0.4 * i, 2, 0}, 0.055));
  }
  parts.push_back(tube({-2, 0, 0.5}, {2, 0.1, 0.6}, 0.08));
  const field::Field ball =
      turned(field::make("sphere", {{"radius", 0.6}}), {1, 0, 0}, 0, {0, 0, 2});
  const field::Field bubble =
      turned(field::make("sphere", {{"radius", 0.16}}), {1, 0, 0}, 0, {0.03, 0.01, 2});
  parts.push_back(field::subtract(ball, {bubble}));
  const field::Field solid = field::unite(parts);
  volume::VoxelizeOptions options;
  options.voxel = 0.1;
  const volume::LevelSet level_set = volume::voxelize(solid, options);
  EXPECT_TRUE(volume::find_small_features(level_set, &solid).empty())
      << volume::describe(volume::find_small_features(level_set, &solid));
}

TEST(SmallTopology, TheSearchCanBeCancelled) {
  const field::Field pore = field::subtract(field::make("sphere", {{"radius", 1.0}}),
                                            {field::make("sphere", {{"radius", 0.06}})});
  volume::VoxelizeOptions options;
  options.voxel = 0.1;
  const volume::LevelSet level_set = volume::voxelize(pore, options);
  Progress progress;
  EXPECT_EQ(volume::find_small_features(level_set, nullptr, progress).size(), 1U);
  progress.cancel();
  try {
    volume::find_small_features(level_set, nullptr, progress);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
  }
}

TEST(SmallTopology, OnlyTheSamplesOfABubbleChange) {
  const field::Field ball = field::make("sphere", {{"radius", 1.0}});
  const field::Field pore =
      turned(field::make("sphere", {{"radius", 0.06}}), {1, 0, 0}, 0, {0.3, 0.2, 0.1});
  const field::Field solid = field::subtract(ball, {pore});
  volume::VoxelizeOptions options;
  options.voxel = 0.1;
  const volume::LevelSet level_set = volume::voxelize(solid, options);
  const auto small = volume::find_small_features(level_set);
  ASSERT_EQ(small.size(), 1U);
  EXPECT_EQ(small[0].kind, volume::SmallFeature::Kind::bubble);
  EXPECT_EQ(small[0].samples, std::vector<Vec3i>({Vec3i(3, 2, 1)}));
  EXPECT_LT((small[0].at - Vec3d(0.3, 0.2, 0.1)).length(), 1e-6);
  EXPECT_EQ(volume::describe(small), "1 bubble, at (0.3, 0.2, 0.1)");
  const volume::LevelSet clean = volume::without_features(level_set, small);
  EXPECT_EQ(euler(clean), 2);
  for (int n = 0; n < 1000; ++n) {
    const Vec3d p = Vec3d(n / 100 - 2, n / 10 % 10 - 3, n % 10 - 4) * 0.1;
    const double expected = level_set.value(p) * ((p - small[0].at).length() < 0.01 ? -1 : 1);
    EXPECT_NEAR(clean.value(p), expected, 1e-6);
  }
  EXPECT_EQ(volume::without_features(level_set, {}).content(), level_set.content());
}

}  // namespace
}  // namespace vug::meshing
