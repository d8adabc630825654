// SPDX-License-Identifier: Apache-2.0
// Walls along the faces of the region of a volume.
#include <vug/building/builder.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <tuple>

namespace vug::building {
namespace {

/// A tunnel along x that leaves the region through both of its faces.
TEST(Caps, CloseTheFacesThatTheyName) {
  const std::string tunnel =
      "volume rock = level_set(-cylinder(radius: 50cm, height: 9m).rotate(axis: (0, 0, 1), angle: "
      "90deg), voxel: 10cm, from: (-2, -1, -1), to: (2, 1, 1)";
  const auto components_and_signs = [&](const std::string& caps) {
    const loading::Loaded scene =
        loading::load_text(tunnel + caps + ")\nmesh skin on rock {}", "t.vug", {});
    EXPECT_EQ(scene.report(), "");
    Builder builder(scene.shot);
    const mesh::Topology topology = mesh::inspect(*builder.mesh(scene.shot.meshes.at(0)));
    const volume::LevelSet& made = builder.level_set(scene.shot.volumes.at(0));
    return std::tuple(topology.components, made.value({-1.9, 0, 0}) < 0,
                      made.value({1.9, 0, 0}) < 0, made.value({0, 0, 0}) < 0);
  };
  EXPECT_EQ(components_and_signs(""), std::tuple(1, false, false, false));
  EXPECT_EQ(components_and_signs(", caps: +X"), std::tuple(1, false, true, false));
  EXPECT_EQ(components_and_signs(", caps: [-X, +X]"), std::tuple(2, true, true, false));
}

TEST(Caps, NeedARegion) {
  const loading::Loaded scene =
      loading::load_text("volume rock = level_set(sphere(1m), caps: +X)", "t.vug", {});
  EXPECT_NE(scene.report().find("'caps' closes faces of the region"), std::string::npos)
      << scene.report();
  const loading::Loaded other = loading::load_text(
      "volume rock = level_set(sphere(1m), from: (0, 0, 0), to: (1, 1, 1), caps: [+X, 3])", "t.vug",
      {});
  EXPECT_NE(other.report().find("'caps' expects a list of directions"), std::string::npos)
      << other.report();
}

}  // namespace
}  // namespace vug::building
