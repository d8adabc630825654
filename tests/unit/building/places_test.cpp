// SPDX-License-Identifier: Apache-2.0
// Instances of `place` declarations: transforms, names, materials and lights.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/building/flat_scene.h>
#include <vug/loading/load.h>
#include <vug/picture/picture.h>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace vug::building {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStones = R"(
seed 5
volume ball  = level_set(sphere(0.2m), voxel: 5cm)
volume block = level_set(box(size: (0.3, 0.2, 0.3)), voxel: 5cm)
volume earth = level_set(box(size: (6, 0.5, 6)), voxel: 20cm)
mesh round on ball {}
mesh cube on block {}
mesh ground on earth {}
material moss = lambert(albedo: (0.1, 0.3, 0.1))
object soil on ground {}
object pebble on round { material lambert() }
object brick on cube {}
)";

/// Tests with a temporary folder.
class Places : public testing::Test {
 protected:
  void file(const std::string& name, const std::string& text) const {
    write_text(folder_ / name, text);
  }
  loading::Loaded loaded(const std::string& text) const {
    return loading::load_text(text, (folder_ / "t.vug").string());
  }
  /// The flattened scene of the text, which may only have warnings.
  FlatScene cast(const std::string& text) const {
    const loading::Loaded scene = loaded(text);
    EXPECT_TRUE(scene.usable()) << scene.report();
    Builder builder(scene.shot);
    return flatten_scene(builder);
  }
  std::string faults(const std::string& text) const { return loaded(text).report(); }

  const ScratchFolder scratch_{"vug_places"};
  const fs::path& folder_ = scratch_.path();
};

Vec3d origin(const render::Object& object) { return Vec3d(object.instance->at(0).origin); }

TEST_F(Places, OnePlaceAndAList) {
  const FlatScene made =
      cast(std::string(kStones) +
           "place pile { of pebble  at [(1, 2, 3), pose(position: (0, 1, 0), yaw: "
           "90deg, scale: 2, stretch: (1, 1, -1))] }\n");
  ASSERT_EQ(made.objects.size(), 4u);  // soil and brick are shown, the placed pebble is not
  EXPECT_EQ(made.objects[0].name, "soil");
  EXPECT_EQ(made.objects[1].name, "brick");
  EXPECT_EQ(made.objects[2].name, "pile");
  EXPECT_EQ(made.objects[2].mesh, made.objects[3].mesh);
  EXPECT_EQ(made.objects[2].material_name, "pebble");
  EXPECT_EQ(origin(made.objects[2]), Vec3d(1, 2, 3));
  const render::Affine to = made.objects[3].instance->at(0);
  EXPECT_LT((to.point({0, 0, 1}) - Vec3f(-2, 1, 0)).length(),
            1e-6f);  // mirrored, then z is rotated to x
  EXPECT_LT(to.determinant(), 0);
}

TEST_F(Places, MaterialOfThePlaceOverridesThatOfTheModel) {
  const FlatScene made =
      cast(std::string(kStones) +
           "place a { of brick  at (1, 0, 0) }\n"
           "place b { of pebble  at [(1, 0, 0), (2, 0, 0)]  material moss  apart true }\n");
  ASSERT_EQ(made.objects.size(), 4u);
  EXPECT_EQ(made.objects[1].material, nullptr);
  EXPECT_FALSE(made.objects[1].world_space_material);
  EXPECT_EQ(made.objects[2].name, "b/1");
  EXPECT_EQ(made.objects[3].name, "b/2");
  EXPECT_EQ(made.objects[3].material_name, "moss");
  EXPECT_TRUE(made.objects[3].world_space_material);
}

TEST_F(Places, ScatterKeepsItsSpacingItsMaskAndItsSeed) {
  const auto text = [](const std::string& more) {
    return std::string(kStones) +
           "place stones { of [pebble, brick]  shares [3, 1]  at scatter(on: ground, spacing: "
           "30cm, "
           "scale: [0.5, 1.5]" +
           more + ") }\n";
  };
  const std::string top = ", where: slope(from: 30deg, to: 20deg)";
  const FlatScene made = cast(text(top)), again = cast(text(top)),
                  other = cast(text(top + ", seed: 1"));
  ASSERT_GT(made.objects.size(), 150u);
  ASSERT_EQ(made.objects.size(), again.objects.size());
  size_t pebbles = 0, same = 0;
  for (size_t i = 1; i < made.objects.size(); ++i) {
    const Vec3d p = origin(made.objects[i]);
    EXPECT_EQ(p, origin(again.objects[i]));
    if (i < other.objects.size()) same += p == origin(other.objects[i]);
    EXPECT_NEAR(p.y, 0.25, 0.05);  // on top, not on the sides or the bottom
    for (size_t j = 1; j < i; ++j) EXPECT_GE((p - origin(made.objects[j])).length(), 0.2999);
    const auto size = static_cast<double>(made.objects[i].instance->mean_scale());
    EXPECT_GE(size, 0.499);
    EXPECT_LE(size, 1.501);
    pebbles += made.objects[i].material != nullptr;
  }
  EXPECT_LT(same, 5u);
  const auto all = static_cast<double>(made.objects.size() - 1);
  EXPECT_NEAR(static_cast<double>(pebbles), 0.75 * all, 5 * std::sqrt(0.75 * 0.25 * all));
}

TEST_F(Places, GravelRestsOnTheGround) {
  const std::string gravel =
      "place stones { of [pebble, brick]  shares [3, 1]  at gravel(on: ground, sizes: [10cm, "
      "30cm], cover: 20%, sink: 0, where: slope(from: 30deg, to: 20deg)) }\n";
  const FlatScene made = cast(std::string(kStones) + gravel), again = cast(kStones + gravel);
  ASSERT_GT(made.objects.size(), 60u);
  ASSERT_EQ(made.objects.size(), again.objects.size());
  size_t pebbles = 0, on_ground = 0;
  for (size_t i = 1; i < made.objects.size(); ++i) {
    const render::Object& stone = made.objects[i];
    EXPECT_EQ(origin(stone), origin(again.objects[i]));
    pebbles += stone.material != nullptr;
    float lowest = 1e9f;
    for (const Vec3f& p : stone.mesh->positions)
      lowest = std::min(lowest, stone.instance->at(0).point(p).y);
    EXPECT_GT(lowest, 0.25 - 0.02);  // Its hull has fewer corners.
    on_ground += lowest < 0.2505;
  }
  // Some lie on others.
  EXPECT_GT(on_ground, made.objects.size() * 7 / 10);
  EXPECT_GT(pebbles, made.objects.size() / 2);
  EXPECT_LT(pebbles, made.objects.size() - 5);
}

TEST_F(Places, GravelNeedsSolidsAndSizes) {
  file("room.vug", "mesh cube on level_set(box(), voxel: 20cm) {}\n");
  EXPECT_THROW(cast(std::string(kStones) +
                    "place stones { of scene(\"room.vug\")  at gravel(on: ground) }\n"),
               Error);
  EXPECT_NE(faults(std::string(kStones) +
                   "place stones { of pebble  at gravel(on: ground, sizes: [30cm, 10cm]) }\n")
                .find("smallest and the largest"),
            std::string::npos);
}

TEST_F(Places, PointsOfATable) {
  file("p.csv",
       "x,y,z,yaw,scale,model,name\n1,2,3,90,2,1,\"a, b\"\n\n# a remark\n-4, 0,0,0,1,0,c\n");
  const FlatScene made =
      cast(std::string(kStones) +
           "place t { of [pebble, brick]  at points(file: \"p.csv\", unit: 1cm) }\n");
  ASSERT_EQ(made.objects.size(), 3u);
  EXPECT_LT((origin(made.objects[1]) - Vec3d(0.01, 0.02, 0.03)).length(), 1e-7);
  EXPECT_EQ(made.objects[1].material, nullptr);
  EXPECT_NE(made.objects[2].material, nullptr);
  EXPECT_NEAR(made.objects[1].instance->mean_scale(), 2, 1e-6);

  file("p.csv", "x,y,z\n1,2,three\n");
  EXPECT_NE(faults(std::string(kStones) + "place t { of pebble  at points(file: \"p.csv\") }\n")
                .find("p.csv:2"),
            std::string::npos);
  file("p.csv", "x,y\n1,2\n");
  EXPECT_NE(faults(std::string(kStones) + "place t { of pebble  at points(file: \"p.csv\") }\n")
                .find("no column 'z'"),
            std::string::npos);
}

TEST_F(Places, AWholeSceneWithItsLightsAndInstances) {
  file("inner.vug", std::string(kStones) +
                        "place pile { of pebble  at [(1, 0, 0), (2, 0, 0)] }\n"
                        "light lamp = sphere(center: (0, 1, 0), radius: 0.1, radiance: (9, 9, 9), "
                        "only: [\"soil\"])\n"
                        "light sky = sky(radiance: (1, 1, 1))\n");
  const FlatScene made = cast(
      "place hall { of scene(\"inner.vug\")  at [(0, 0, 0), pose(position: (10, "
      "0, 0), scale: 2)] }\n");
  ASSERT_EQ(made.objects.size(), 8u);
  EXPECT_EQ(made.objects[0].name, "hall/soil");
  EXPECT_EQ(made.objects[2].name, "hall/pile");
  EXPECT_EQ(origin(made.objects[7]), Vec3d(14, 0, 0));
  EXPECT_EQ(made.objects[2].mesh, made.objects[7].mesh);
  ASSERT_EQ(made.lights.size(), 2u);  // without the sky
  EXPECT_LT((made.lights[1]->center() - Vec3f(10, 2, 0)).length(), 1e-5f);
  EXPECT_EQ(made.lights[1]->linking().only, std::vector<std::string>{"hall/soil"});
  const float strength = made.lights[0]->bounds().strength;
  EXPECT_NEAR(made.lights[1]->bounds().strength, 4 * strength, 1e-3 * strength);
}

// A grove of plants with leaves: one instance per leaf and plant would be too many.
TEST_F(Places, CopiesInAFrequentlyPlacedSceneBecomeOneMesh) {
  file("leaf.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  file(
      "plant.vug",
      "mesh blade { file \"leaf.obj\" }\nmesh wood { file \"leaf.obj\" }\nobject stem on wood {}\n"
      "object leaf on blade { material surface(thin: true) }\n"
      "place crown { of leaf  at grove(polygon: [(0, 0), (9, 0), (9, 9), (0, 9)], count: 300) }\n");
  const auto text = [](int count) {
    return "place grove { of scene(\"plant.vug\")  at grove(polygon: [(0, 0), (99, 0), (99, 99)], "
           "count: " +
           std::to_string(count) + ") }\n";
  };
  const FlatScene few = cast(text(3)), many = cast(text(200));
  EXPECT_EQ(few.objects.size(), 3u * 301);
  ASSERT_EQ(many.objects.size(), 2u * 200);
  EXPECT_EQ(many.objects[0].name, "grove/stem");
  EXPECT_EQ(many.objects[1].name, "grove/crown");
  EXPECT_EQ(many.objects[1].mesh, many.objects[3].mesh);
  EXPECT_EQ(many.objects[1].mesh->triangles.size(), 300u);
  ASSERT_TRUE(mesh::find_attribute(*many.objects[1].mesh, "copy"));
  // The first plant has the same points in both cases.
  for (size_t leaf = 0; leaf < 300; ++leaf)
    for (uint32_t corner = 0; corner < 3; ++corner) {
      const render::Object& one = few.objects[1 + leaf];
      const Vec3f alone = one.instance->at(0).point(one.mesh->positions[corner]);
      const auto number = many.objects[1].mesh->triangles[leaf][corner];
      const Vec3f merged =
          many.objects[1].instance->at(0).point(many.objects[1].mesh->positions[number]);
      ASSERT_LT((alone - merged).length(), 1e-4f);
    }
}

TEST_F(Places, ReportsWhatCannotBePlaced) {
  const std::string stones = kStones;
  EXPECT_NE(faults(stones + "place a { of pebbel  at (0, 0, 0) }\n").find("pebbel"),
            std::string::npos);
  EXPECT_NE(faults(stones + "place a { of pebble  at (0, 0, 0)  shares [1, 2] }\n").find("shares"),
            std::string::npos);
  EXPECT_NE(faults(stones + "place a { of pebble  at pose(stretch: (1, 0, 1)) }\n").find("flat"),
            std::string::npos);
  EXPECT_NE(faults(stones + "place a { of []  at (0, 0, 0) }\n").find("nothing to place"),
            std::string::npos);
  file("loop.vug", "place a { of scene(\"loop.vug\")  at (0, 0, 0) }\n");
  EXPECT_NE(
      faults("place a { of scene(\"loop.vug\")  at (0, 0, 0) }\n").find("would contain itself"),
      std::string::npos);
  EXPECT_NE(loading::load(folder_ / "loop.vug").report().find("would contain itself"),
            std::string::npos);
  file("lamp.vug", "light lamp = sphere(radius: 0.1)\n");
  EXPECT_THROW(cast("place a { of scene(\"lamp.vug\")  at pose(stretch: (1, 2, 1)) }\n"), Error);
}

}  // namespace
}  // namespace vug::building
