// SPDX-License-Identifier: Apache-2.0
// Cameras that are shots of `vug scout`.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/load.h>
#include <vug/loading/scouted_cameras.h>

#include <filesystem>

namespace vug::loading {
namespace {
namespace fs = std::filesystem;

const std::string kBall = "volume rock = level_set(sphere(1m), voxel: 20cm)\n";

class ScoutedCamera : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "my_shots");
    write_text(folder_ / "my_shots/shot3.vug",
               "camera shot3 { eye (7, 0, 0)  target (0, 0, 0) }\n"
               "light shot3_key = sphere(center: (2, 3, 0), radius: 5cm, lumen: 700)\n");
  }

  Loaded scene(const std::string& text, const LoadOptions& options = {}) {
    return load_text(kBall + text, (folder_ / "my.vug").string(), options);
  }
  std::string messages(const std::string& text) {
    std::string out;
    const Loaded loaded = scene(text);
    for (const Diagnostic& each : loaded.diagnostics.all())
      out += each.message + ": " + each.hint + "\n";
    return out;
  }

  const ScratchFolder scratch_{"vug_scouted_camera"};
  const fs::path folder_ = scratch_.path();
};

TEST_F(ScoutedCamera, IsTheCameraOfTheShotWithItsLamps) {
  const Loaded loaded = scene("camera main { scout 3 }\nrender main { camera main }\n");
  ASSERT_TRUE(loaded.usable()) << loaded.report();
  EXPECT_EQ(loaded.report(), "");
  bool found = false;
  for (const shot::CameraPlan& each : loaded.shot.cameras) {
    if (each.name != "main") continue;
    found = true;
    EXPECT_EQ(each.camera->position(), Vec3f(7, 0, 0));
    EXPECT_EQ(each.camera, loaded.shot.renders.at(0).settings.camera);
  }
  EXPECT_TRUE(found);
  ASSERT_EQ(loaded.shot.lights.size(), 1u);
  EXPECT_EQ(loaded.shot.lights[0].first, "main_shot.shot3_key");
}

TEST_F(ScoutedCamera, TheDigestOfTheSceneCoversTheShot) {
  const Digest before = scene("camera main { scout 3 }\n").shot.text_digest;
  write_text(folder_ / "my_shots/shot3.vug", "camera shot3 { eye (8, 0, 0) }\n");
  EXPECT_FALSE(scene("camera main { scout 3 }\n").shot.text_digest == before);
}

TEST_F(ScoutedCamera, AMissingShotNamesTheCommand) {
  const std::string text = messages("camera main { scout 4 }\n");
  EXPECT_NE(text.find("the scene has no shot 4: '"), text.npos) << text;
  EXPECT_NE(text.find("my_shots/shot4.vug' does not exist: find the shots with: vug scout "),
            text.npos);
}

TEST_F(ScoutedCamera, Refusals) {
  for (const char* value : {"0", "1.5", "3m", "\"3\"", "3, 4", "-3"})
    EXPECT_EQ(messages(std::string("camera main { scout ") + value + " }\n"),
              "'scout' takes the number of a shot, from 1: write camera main { scout 3 }\n")
        << value;
  EXPECT_EQ(messages("camera main { scout 3  fov 50deg }\n"),
            "a camera with 'scout' has no other values: copy the camera from the file of the shot, "
            "and change it\n");
}

TEST_F(ScoutedCamera, TheSearchOfShotsForgetsThem) {
  LoadOptions options;
  options.unscouted = true;
  const Loaded loaded = scene("camera main { scout 4 }\n", options);
  ASSERT_TRUE(loaded.usable()) << loaded.report();
  EXPECT_EQ(loaded.shot.cameras.size(), 1u);
  EXPECT_TRUE(loaded.shot.lights.empty());
}

}  // namespace
}  // namespace vug::loading
