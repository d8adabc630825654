// SPDX-License-Identifier: Apache-2.0
// Warnings: valid but probably unintended input is reported with its location, and the work
// continues.
#include <gtest/gtest.h>
#include <vug/loading/load.h>
#include <vug/picture/render_job.h>

namespace vug::picture {
namespace {

/// All messages of loading the scene and rendering a small picture.
std::string messages(const std::string& text) {
  const loading::Loaded loaded = loading::load_text(text, "t.vug");
  std::string out = loaded.report();
  if (!loaded.usable()) return out;
  building::BuildOptions options;
  options.on_warning = [&](const Diagnostics& doubtful) { out += loaded.report(doubtful); };
  building::Builder builder(loaded.shot, options);
  PictureOptions picture;
  picture.settings = {{"size", List{4, 3}}, {"spp", 1}};
  render_picture(builder, plan_picture(loaded.shot, picture));
  return out;
}

/// The message without the quoted source line.
std::string lines(const std::string& report, const std::string& start) {
  std::string out;
  for (size_t at = 0; at < report.size(); at = report.find('\n', at) + 1) {
    const std::string line = report.substr(at, report.find('\n', at) - at);
    if (line.find(start) == 0) out += line + "\n";
  }
  return out;
}

const std::string kRoom =
    "volume rock = level_set(box(size: (6, 6, 6)) - sphere(2m), voxel: 20cm)\n";

TEST(Warning, ACameraInsideRock) {
  const std::string report = messages(kRoom + "camera main { eye (2.5, 0, 0) }\n");
  EXPECT_EQ(report,
            "t.vug:2:8: warning: the camera is inside the solid of 'rock'\n"
            "camera main { eye (2.5, 0, 0) }\n"
            "       ^~~~\n"
            "hint: move its eye out of the solid\n");
  EXPECT_EQ(messages(kRoom + "camera main { eye (1, 0, 0) }\n"), "");
  EXPECT_EQ(messages(kRoom + "camera main { eye (9, 0, 0) }\n"), "");
  EXPECT_EQ(messages(kRoom), "") << "the camera that looks from outside";
}

TEST(Warning, OnlyTheCameraAndTheObjectsOfThePictureCount) {
  const std::string cameras = "camera out { eye (9, 0, 0) }\ncamera inside { eye (2.5, 0, 0) }\n";
  EXPECT_EQ(messages(kRoom + cameras), "");
  EXPECT_EQ(lines(messages(kRoom + cameras + "render main { camera inside }\n"), "t.vug:"),
            "t.vug:3:8: warning: the camera is inside the solid of 'rock'\n");
  const std::string shown =
      "volume ball = level_set(sphere(1m), voxel: 20cm)\n"
      "mesh wall on ball {}\nobject all on wall {}\n";
  EXPECT_EQ(messages(kRoom + shown + "camera inside { eye (2.5, 0, 0) }\n"), "");
}

TEST(Warning, AnEmptyGrid) {
  const auto hint = [](const std::string& volume) {
    const std::string report = messages("volume rock = " + volume + "\n");
    EXPECT_EQ(lines(report, "t.vug:"), "t.vug:1:8: warning: the volume 'rock' is empty\n");
    return lines(report, "hint: ");
  };
  EXPECT_EQ(hint("level_set(sphere(1m) & sphere(1m).translate((9, 0, 0)), voxel: 10cm)"),
            "hint: its solid is empty\n");
  EXPECT_EQ(hint("level_set(sphere(1m), voxel: 10cm, from: (5, 5, 5), to: (6, 6, 6))"),
            "hint: its solid lies outside of 'from' and 'to'\n");
  const std::string thin = "hint: its solid is empty or thinner than a voxel\n";
  EXPECT_EQ(hint("level_set(sphere(1m).offset(-2m), voxel: 1m)"), thin);
  const std::string plate = messages(
      "volume rock = level_set(box(size: (2, 2, 0.01)).translate((0, 0, 0.05)), voxel: 20cm)\n");
  EXPECT_NE(plate.find("the volume 'rock' is empty"), std::string::npos);
  EXPECT_NE(plate.find("the box in the volume 'rock' is 0.01 m thick at (0, 0, 0.05)"),
            std::string::npos);
  EXPECT_NE(plate.find("use voxels of at most 0.005 m"), std::string::npos);
}

TEST(Warning, AGrammarThatProducesNothing) {
  const auto grammar = [](const std::string& axiom) {
    return "param N = 0\ngrammar cave {\n  axiom " + axiom +
           "\n  Room if N > 0 -> + sphere(1m)\n}\n" +
           "volume rock = level_set(box() + cave, voxel: 20cm)\n";
  };
  EXPECT_EQ(lines(messages(grammar("Room*N")), "t.vug:"),
            "t.vug:2:9: warning: the grammar 'cave' produces nothing\n");
  EXPECT_EQ(lines(messages(grammar("Room")), "t.vug:"),
            "t.vug:2:9: warning: 'Room' at cave/Room[0] was never expanded to a production\n"
            "t.vug:2:9: warning: the grammar 'cave' produces nothing\n");
  EXPECT_EQ(messages(grammar("+ sphere(1m) Room*N")), "");
}

}  // namespace
}  // namespace vug::picture
