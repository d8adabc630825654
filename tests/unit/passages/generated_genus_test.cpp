// SPDX-License-Identifier: Apache-2.0
// The surface of a generated cave has as many handles as its network has independent cycles: its
// passages do not cross or touch each other without a junction.
#include "passage_samples.h"

#include <gtest/gtest.h>
#include <vug/karst/generate.h>
#include <vug/karst/presets.h>
#include <vug/mesh/topology.h>
#include <vug/network/reduction.h>
#include <vug/volume/polygons.h>
#include <vug/volume/small_features.h>
#include <vug/volume/voxelize.h>

#include <cstdlib>

namespace vug::passages {
namespace {

constexpr double kRadius = 0.5;  ///< Metres.
constexpr double kVoxel = 0.25;  ///< At larger voxels, gaps between passages close.

/// Half of the sides and a quarter of the samples of a preset, so that a test takes half a second.
network::Network small_cave(const karst::Preset& preset, uint64_t seed) {
  karst::Geology geology = preset.geology;
  for (const int axis : {0, 2}) {
    geology.bounds.min[axis] *= 0.5;
    geology.bounds.max[axis] *= 0.5;
  }
  karst::KarstOptions options = preset.options;
  options.seed = seed;
  options.samples.count /= 4;
  options.growth.sinks = (options.growth.sinks + 1) / 2;
  options.growth.dead_ends /= 3;
  return karst::generate(geology, options);
}

/// Tubes along the straight legs, without the handles that voxels make in crotches.
mesh::Topology topology_of_tubes(const network::Network& cave) {
  PassageOptions options;
  options.smooth = false;
  options.rules.clear();
  options.chamber = 1;
  options.fillet = 0;
  const field::Field air = passages(with_radius(cave, kRadius), options);
  volume::VoxelizeOptions voxels;
  voxels.voxel = kVoxel;
  const volume::LevelSet sampled = volume::voxelize(air, voxels);
  const volume::Polygons polygons = volume::polygons_of(
      volume::without_features(sampled, volume::find_small_features(sampled, &air)));
  mesh::Mesh mesh;
  mesh.positions = polygons.points;
  for (const auto& t : polygons.triangles) mesh.triangles.push_back({t[0], t[1], t[2]});
  for (const auto& q : polygons.quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh::inspect(mesh);
}

/// VUG_GENUS_SEEDS=8 tests eight seeds of each preset instead of one.
TEST(GeneratedGenus, IsTheNumberOfCycles) {
  const char* text = std::getenv("VUG_GENUS_SEEDS");
  const int seeds = text ? std::max(1, std::atoi(text)) : 1;
  for (const karst::Preset& preset : karst::presets())
    for (int seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(testing::Message() << preset.name << ", seed " << seed);
      const network::Network cave = small_cave(preset, static_cast<uint64_t>(seed));
      const network::Graph graph = network::cave_graph(cave).graph;
      const mesh::Topology topology = topology_of_tubes(cave);
      EXPECT_EQ(topology.components, 1U);
      ASSERT_TRUE(topology.genus.has_value());
      EXPECT_EQ(static_cast<int>(*topology.genus),
                static_cast<int>(graph.edges.size()) - graph.nodes + 1);
      EXPECT_GT(cave.legs.size(), 100U);
    }
}

}  // namespace
}  // namespace vug::passages
