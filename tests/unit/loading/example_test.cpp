// SPDX-License-Identifier: Apache-2.0
// Every kind of `vug list` has an example that can be copied: it parses and evaluates together with
// the declarations that it may refer to.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/field/registry.h>
#include <vug/image/io.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/example.h>
#include <vug/loading/load.h>
#include <vug/mesh/format.h>
#include <vug/volume/io.h>
#include <vug/volume/voxelize.h>

namespace vug::loading {
namespace {

/// A folder with the files that examples name.
class Examples : public testing::Test {
 protected:
  Examples() : folder_("examples") {
    image::Image picture(4, 2, {"R", "G", "B"});
    for (float& value : picture.pixels) value = 0.5f;
    for (const char* name : {"hills.exr", "sky.exr"}) image::write_exr(folder_.file(name), picture);
    image::write_png(folder_.file("colours.png"), picture);
    mesh::Mesh stone;
    stone.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    stone.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    mesh::write_mesh(stone, folder_.file("stone.ply"));
    write_text(folder_.file("stones.csv"), "x,y,z\n1,0,0\n2,0,1\n");
    write_text(folder_.file("hill.asc"),
               "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n1 2\n3 5\n");
    write_text(folder_.file("cave.svx"), "*fix a 0 0 0\na b 9 40 5\nb c 7 80 -10\n");
    write_text(folder_.file("cave_nodes.dat"), "0 0 0\n9 0 -2\n15 4 -3\n");
    write_text(folder_.file("cave_links.dat"), "1 2\n2 3\n");
    write_text(folder_.file("room.vug"), "volume room = level_set(sphere(1m), voxel: 20cm)\n");
    std::filesystem::copy_file(std::filesystem::path(VUG_TEST_DATA) / "lights" / "cosine.ies",
                               folder_.file("lamp.ies"));
    std::filesystem::copy_file(std::filesystem::path(VUG_TEST_DATA) / "volumes" / "fire.vdb",
                               folder_.file("fire.vdb"));
    volume::VoxelizeOptions options;
    options.voxel = 0.2;
    volume::write(folder_.file("rock.vdb"),
                  {volume::voxelize(field::make("sphere"), options).named("rock")});
  }
  Loaded loaded(const std::string& example) const {
    return load_text(example_scene() + example + "\n", folder_.file("t.vug").string());
  }

  ScratchFolder folder_;
};

TEST_F(Examples, AllOfThemAreValid) {
  size_t commands = 0;
  for (const KindInfo* kind : find_kinds()) {
    const std::string example = example_of(*kind);
    SCOPED_TRACE(kind->category + " " + kind->name + ": " + example);
    EXPECT_NE(example, "");
    if (example.rfind("vug ", 0) == 0) {
      EXPECT_NE(example.find(kind->name), std::string::npos);
      ++commands;
      continue;
    }
    const Loaded scene = loaded(example);
    EXPECT_TRUE(scene.usable()) << scene.report();
  }
  EXPECT_GT(commands, 10u);
}

TEST_F(Examples, UseTheirKind) {
  for (const KindInfo* kind : find_kinds()) {
    if (kind->name.find("NAME") != std::string::npos || kind->category == "declaration") continue;
    EXPECT_NE(example_of(*kind).find(kind->name), std::string::npos) << kind->name;
  }
}

TEST(Search, FindsDescriptionsAndSynonyms) {
  const auto names = [](const std::string& text) {
    std::vector<std::string> all;
    for (const KindInfo* kind : search_kinds(text)) all.push_back(kind->name);
    return all;
  };
  EXPECT_EQ(names("stalactite"),
            (std::vector<std::string>{"soda_straw", "stalactite", "lavacicles", "dripstone",
                                      "speleothems", "seepage", "drip_points"}));
  EXPECT_EQ(names("HDRI"), std::vector<std::string>{"sky_image"});
  EXPECT_EQ(names("hdri"), std::vector<std::string>{"sky_image"});
  EXPECT_GE(names("AOV").size(), 20u);
  EXPECT_EQ(names("wet rock").front(), "coated");
  EXPECT_EQ(names("area light"), (std::vector<std::string>{"disk", "rect"}));
  EXPECT_EQ(names("no such thing"), std::vector<std::string>{});
  EXPECT_EQ(names(""), std::vector<std::string>{});
}

}  // namespace
}  // namespace vug::loading
