// SPDX-License-Identifier: Apache-2.0
// Mistakes of set dressing are found before a picture is rendered: cameras and lights in rock,
// props in mid-air and filled voids; their legitimate neighbours are not reported.
#include <gtest/gtest.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/placement/check.h>
#include <vug/mesh/format.h>
#include <vug/mesh/winding_number.h>

#include <fmt/format.h>

namespace vug::loading {
namespace {

/// The messages without source lines; `text` must be free of errors.
std::string mistakes(const std::string& text, const PlacementOptions& options = {}) {
  const Loaded loaded = load_text(text, "t.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  Diagnostics found;
  check_placement(loaded, options, found);
  std::string out;
  for (const Diagnostic& one : found.all())
    out += fmt::format("{}: {}\n{}\n", to_string(one.where), one.message, one.hint);
  return out;
}

/// A room of 4 m in a block of rock, with its floor at y = 0.
const std::string kRoom =
    "field room = box(size: (4, 4, 4)).translate((0, 2, 0))\n"
    "field block = box(size: (8, 8, 8)).translate((0, 2, 0)) - room\n"
    "volume rock = level_set(block, voxel: 10cm)\nmesh wall on rock {}\nobject walls on wall {}\n";

TEST(Placement, ACameraInRock) {
  EXPECT_EQ(mistakes(kRoom + "camera main { eye (2.5, 1, 0)  target (1, 1, -5) }\n"),
            "t.vug:6:8: the camera 'main' at (2.5, 1, 0) is in rock, 0.50 m inside 'walls'\n"
            "the nearest air is 0.50 m towards -x: eye (1.9, 1, 0)\n");
  EXPECT_EQ(mistakes(kRoom + "camera main { eye (0, -0.75, 0)  target (1, 1, -5) }\n"),
            "t.vug:6:8: the camera 'main' at (0, -0.75, 0) is in rock, 0.75 m inside 'walls'\n"
            "the nearest air is 0.75 m above: eye (0, 0.1, 0)\n");
  EXPECT_EQ(mistakes(kRoom + "camera main { eye (1.5, 1, 0)  target (1, 1, -5) }\n"), "");
  EXPECT_EQ(mistakes(kRoom + "camera main { eye (0, 2, 9)  target (1, 1, -5) }\n"), "");
  EXPECT_EQ(mistakes(kRoom + "camera main { eye (2.02, 1, 0)  target (1, 1, -5) }\n"), "")
      << "within half a voxel";
  EXPECT_EQ(
      mistakes(kRoom + "camera cut { kind orthographic  eye (2.5, 1, 0)  target (1, 1, -5) }\n"),
      "");
}

TEST(Placement, VoxelsMayCloseTheAirAroundACamera) {
  const auto corridor = [](const std::string& voxel) {
    return mistakes(
        "volume rock = level_set(box(size: (8, 8, 8)) - box(size: (60cm, 60cm, 7m)), voxel: " +
        voxel +
        ")\nmesh wall on rock {}\nobject walls on wall {}\n"
        "camera main { eye (0.2, 0.2, 2.2)  target (0, 0, -5) }\n");
  };
  EXPECT_EQ(corridor("20cm"), "");
  EXPECT_EQ(corridor("90cm"),
            "t.vug:4:8: the voxels of 'walls' (0.9 m) close the air around the camera 'main'\n"
            "choose smaller voxels, or move the camera away from the wall\n");
}

TEST(Placement, OnlyTheChosenCameraIsChecked) {
  const std::string two = kRoom +
                          "camera good { eye (0, 1, 0)  target (1, 1, -5) }\ncamera bad { eye (3, "
                          "1, 0)  target (1, 1, -5) }\n";
  EXPECT_EQ(mistakes(two, {.camera = "good"}), "");
  EXPECT_NE(mistakes(two, {.camera = "bad"}).find("the camera 'bad'"), std::string::npos);
  EXPECT_NE(mistakes(two).find("the camera 'bad'"), std::string::npos);
}

TEST(Placement, ALightInRockWithAllOfItsShape) {
  EXPECT_EQ(mistakes(kRoom + "light lamp = sphere(center: (0, 4.5, 0), radius: 10cm)\n"),
            "t.vug:6:1: the light 'lamp' at (0, 4.5, 0) is in rock, 0.50 m inside 'walls'\n"
            "the nearest air is 0.50 m below: center: (0, 3.9, 0)\n");
  const auto panel = [](double y, double width) {
    return mistakes(kRoom +
                    fmt::format("light panel = rect(center: (0, {}, 0), normal: (0, -1, 0), "
                                "width: {}, height: 1)\n",
                                y, width));
  };
  EXPECT_EQ(panel(3.99, 1), "") << "close to the ceiling";
  EXPECT_EQ(panel(2, 5), "") << "its corners are in the walls";
  EXPECT_NE(panel(4.2, 1), "") << "the whole panel is in the ceiling";
  EXPECT_EQ(mistakes(kRoom + "light lamp = sphere(center: (0, 4.2, 0), radius: 40cm)\n"), "")
      << "half of it looks out of the ceiling";
  EXPECT_EQ(mistakes(kRoom + "light day = sky()\nlight sun = sun()\n"
                             "light mouth = portal(center: (3, 2, 0))\n"),
            "");
}

TEST(Placement, BodiesThatLightLeavesAreNotRock) {
  const auto body = [](const std::string& material) {
    return mistakes(
        "volume v = level_set(sphere(1m), voxel: 10cm)\nmesh ball on v {}\n"
        "object glow on ball { material " +
        material +
        " }\n"
        "light lamp = sphere(radius: 10cm)\ncamera main { eye (0, 0.5, 0)  target (1, 1, -5) }\n");
  };
  EXPECT_EQ(body("surface(transmission: 1)"), "");
  EXPECT_EQ(body("surface(thin: true)"), "");
  const std::string calcite = body("surface(subsurface: 0.9)");
  EXPECT_NE(calcite.find("the camera 'main'"), std::string::npos);
  EXPECT_EQ(calcite.find("the light"), std::string::npos) << calcite;
  const std::string opaque = body("lambert()");
  EXPECT_NE(opaque.find("the camera 'main'"), std::string::npos);
  EXPECT_NE(opaque.find("the light 'lamp'"), std::string::npos);
}

/// A scene with a prop, a cube of 40 cm whose origin is in its middle.
std::string with_prop(const std::string& at) {
  return kRoom +
         "volume c = level_set(box(size: (0.4, 0.4, 0.4)), voxel: 4cm)\nmesh cube on c {}\n"
         "object chest on cube {}\nplace chests { of chest  at " +
         at + " }\n";
}

TEST(Placement, APropInMidAir) {
  EXPECT_EQ(mistakes(with_prop("(0, 1.2, 0)")),
            "t.vug:9:7: 'chests' floats 1.00 m above 'walls': its foot is at (0, 1, 0)\n"
            "move it down by 1.00 m, or write 'floating true' if it hangs there on purpose\n");
  EXPECT_EQ(mistakes(with_prop("[(1, 0.2, 0), pose(position: (0, 0.7, 0), yaw: 30deg)]")),
            "t.vug:9:7: instance 2 of 'chests' floats 0.50 m above 'walls': its foot is at "
            "(0, 0.5, 0)\n"
            "move it down by 0.50 m, or write 'floating true' if it hangs there on purpose\n");
  EXPECT_EQ(mistakes(with_prop("(0, 1.2, 0) floating true")), "") << "on purpose";
  EXPECT_EQ(mistakes(with_prop("(0, 0.2, 0)")), "") << "on the floor";
  EXPECT_EQ(mistakes(with_prop("(0, 0.05, 0)")), "") << "partly in the floor";
  EXPECT_EQ(mistakes(with_prop("(1.8, 1.5, 0)")), "") << "on a wall";
  EXPECT_EQ(mistakes(with_prop("(0, 3.8, 0)")), "") << "under the ceiling";
  EXPECT_EQ(mistakes(with_prop("[(0, 0.2, 0), (0, 0.6, 0)]")), "") << "one on the other";
  EXPECT_EQ(mistakes(with_prop("(0, 1, 20)")), "") << "without ground below";
}

TEST(Placement, ALevelSetInMidAirIsAWarning) {
  const Loaded loaded =
      load_text(kRoom +
                    "volume c = level_set(sphere(40cm).translate((0, 2, 0)), voxel: 4cm)\n"
                    "mesh round on c {}\nobject ball on round {}\n",
                "t.vug");
  Diagnostics found;
  check_placement(loaded, {}, found);
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_FALSE(found.has_errors());
  EXPECT_EQ(found.all()[0].message,
            "'ball' floats 1.60 m above 'walls': its foot is at (0, 1.6, 0)");
}

TEST(Placement, LampsMayHang) {
  const std::string bulb =
      "volume c = level_set(sphere(10cm), voxel: 2cm)\nmesh globe on c {}\n"
      "object bulb on globe {@}\nplace lamp { of bulb  at (0, 2, 0) }\n";
  const auto lamp = [&](const std::string& block) {
    std::string text = kRoom + bulb;
    return mistakes(text.replace(text.find('@'), 1, block));
  };
  EXPECT_EQ(lamp(" emission (9, 9, 9) "), "");
  EXPECT_NE(lamp(""), "");
}

TEST(Placement, AFilledVoid) {
  const std::string cave =
      "let hall = sphere(2m)\nfield block = box(size: (9, 9, 9)) - hall\n"
      "volume rock = level_set(@, voxel: 10cm)\n";
  const auto filled = [&](const std::string& field) {
    std::string text = cave;
    return mistakes(text.replace(text.find('@'), 1, field));
  };
  EXPECT_EQ(filled("block + sphere(3m)"),
            "t.vug:1:12: this void is filled: 'rock' has rock in all of it\n"
            "another solid is united with the rock after the void has been removed: unite it "
            "first, and remove the void last\n");
  EXPECT_NE(filled("displace(block + sphere(3m), amount: 10cm)"), "");
  EXPECT_NE(filled("union([block, box(size: (5, 5, 5))], blend: smooth(20cm))"), "");
  EXPECT_NE(filled("block.translate((0, 0, 20)) + sphere(3m).translate((0, 0, 20))"), "");
  EXPECT_NE(
      filled("block.rotate(axis: (0, 1, 0), angle: 30deg).scale(by: 2).translate((5, 0, 0)) + "
             "box(size: (10, 10, 10)).translate((5, 0, 0))"),
      "");
  EXPECT_EQ(filled("block.translate((0, 0, 20)) + sphere(3m)"), "") << "the void has moved away";
  EXPECT_EQ(filled("block"), "");
  EXPECT_EQ(filled("block + cylinder(radius: 1m, height: 9m)"), "") << "a pillar in the hall";
  EXPECT_EQ(filled("block + sphere(1.9m).translate((0, -0.5, 0))"), "") << "a gap at the roof";
  EXPECT_EQ(filled("(block + sphere(3m)) - sphere(1m)"), "") << "with a void of its own";
  EXPECT_EQ(
      filled("box(size: (9, 9, 9)) - (hall - cylinder(radius: 50cm, height: 9m)) + sphere(50cm)"),
      "")
      << "what is removed from a void is rock";
}

TEST(Placement, GrammarsMayFillTheirVoids) {
  EXPECT_EQ(mistakes("grammar cave {\n  axiom Hall Fill\n  Hall -> - sphere(1m)\n"
                     "  Fill -> + box(size: (5, 5, 5))\n}\n"
                     "volume rock = level_set(box(size: (3, 3, 3)) + cave, voxel: 10cm)\n"),
            "");
}

TEST(Placement, MeshesOfFilesAreSolids) {
  const ScratchFolder folder("placement");
  mesh::Mesh box;
  for (int corner = 0; corner < 8; ++corner)
    box.positions.emplace_back(corner & 1 ? 1.f : -1.f, corner & 2 ? 1.f : -1.f,
                               corner & 4 ? 1.f : -1.f);
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  EXPECT_NEAR(mesh::winding_number(box, {0.2, 0.5, -0.3}), 1, 1e-12);
  EXPECT_NEAR(mesh::winding_number(box, {0.2, 1.5, -0.3}), 0, 1e-12);
  mesh::write_mesh(box, folder.file("box.ply"));
  const std::string file = (folder.file("box.ply")).string();
  const std::string rock =
      "mesh stone { file \"" + file + "\"  scale 4 }\nobject boulder on stone {}\n";
  EXPECT_EQ(mistakes(rock + "camera main { eye (0, 3, 0)  target (1, 1, -5) }\n"
                            "light lamp = sphere(center: (0, 0, 3.5), radius: 10cm)\n"),
            "t.vug:3:8: the camera 'main' at (0, 3, 0) is in rock, 1.00 m inside 'boulder'\n"
            "the nearest air is 1.00 m above: eye (0, 4.1, 0)\n"
            "t.vug:4:1: the light 'lamp' at (0, 0, 3.5) is in rock, 0.50 m inside 'boulder'\n"
            "the nearest air is 0.50 m towards +z: center: (0, 0, 4.1)\n");
  EXPECT_EQ(mistakes(rock + "camera main { eye (0, 5, 0)  target (1, 1, -5) }\n"), "");
  const std::string prop =
      "mesh small { file \"" + file + "\"  scale 0.2 }\nobject cube on small {}\n";
  const auto dressed = [&](const std::string& at) {
    return mistakes(rock + prop + "place chest { of cube  at " + at + " }\n");
  };
  EXPECT_EQ(dressed("(0, 4.7, 0)"),
            "t.vug:5:7: 'chest' floats 0.50 m above 'boulder': its foot is at (0, 4.5, 0)\n"
            "move it down by 0.50 m, or write 'floating true' if it hangs there on purpose\n");
  EXPECT_EQ(dressed("(0, 4.2, 0)"), "");
  EXPECT_EQ(dressed("(4.2, 1, 0)"), "") << "on the side";
  // A shell with a hole still has an inside.
  box.triangles.pop_back();
  EXPECT_GT(mesh::winding_number(box, {0, 0, 0}), 0.5);
}

TEST(Placement, SpeleothemsAreComputedOnlyIfTheyMatter) {
  const std::string drips =
      kRoom.substr(0, kRoom.find("volume")) +
      "field grown = dripstone(block, from: (-2, 0, -2), to: (2, 4, 2), spacing: 40cm, age: "
      "14000)\n"
      "volume rock = level_set(grown, voxel: 10cm)\nmesh wall on rock {}\nobject walls on wall {}\n"
      "camera main { eye (0, 2, 0)  target (1, 1, -5) }\n";
  const Loaded loaded = load_text(drips, "t.vug");
  Diagnostics found;
  check_placement(loaded, {}, found);
  EXPECT_TRUE(found.all().empty()) << loaded.report(found);
  EXPECT_NE(field::to_string(loaded.shot.volumes[0]->field).find("deferred"), std::string::npos);
  const Loaded deep =
      load_text(drips + "light lamp = sphere(center: (3, 2, 0), radius: 10cm)\n", "t.vug");
  check_placement(deep, {}, found);
  EXPECT_EQ(found.all().size(), 1u);
  EXPECT_NE(field::to_string(deep.shot.volumes[0]->field).find("deferred"), std::string::npos);
}

}  // namespace
}  // namespace vug::loading
