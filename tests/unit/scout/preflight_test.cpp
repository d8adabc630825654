// SPDX-License-Identifier: Apache-2.0
// The test before a render.
#include "rooms.h"

#include <vug/picture/render_job.h>
#include <vug/scout/preflight.h>

#include <numeric>

namespace vug::scout {
namespace {

const std::string kCamera = "camera main { eye (-10, 2, 0)  target (1, 2, 0) }\n";
const std::string kLamp = "light lamp = sphere(center: (2, 4, 0), radius: 20cm, lumen: 3000)\n";

std::string findings(const std::string& text, const NamedValues& settings = {}) {
  const loading::Loaded loaded = loading::load_text(text, "t.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  building::Builder builder(loaded.shot);
  picture::PictureOptions options;
  options.settings = settings;
  options.settings.emplace_back("size", List{16, 9});
  options.settings.emplace_back("spp", 1);
  const auto plan = picture::plan_picture(loaded.shot, options);
  std::string out;
  picture::RenderOptions render;
  render.inspect = [&](const render::PreparedRender& prepared) {
    for (const auto& each : preflight(prepared, plan.render.settings))
      out += each.message + ": " + each.hint + "\n";
  };
  picture::render_picture(builder, plan, render);
  return out;
}

TEST(Preflight, AMeteredPictureIsFine) { EXPECT_EQ(findings(hall(kCamera + kLamp)), ""); }

TEST(Preflight, FixedExposuresThatAreFarOffNameTheMeteredOne) {
  const std::string dark = findings(hall(kCamera + kLamp), {{"exposure", -12}});
  EXPECT_NE(dark.find("the picture will be black: --exposure "), dark.npos) << dark;
  EXPECT_NE(dark.find("the exposure is -12.0"), dark.npos);
  const std::string bright = findings(hall(kCamera + kLamp), {{"exposure", 14}});
  EXPECT_NE(bright.find("parts of the picture will be burnt out: "), bright.npos) << bright;
  // The remedy works: the named exposure has no finding.
  const size_t at = dark.find("--exposure ") + 11;
  EXPECT_EQ(findings(hall(kCamera + kLamp), {{"exposure", std::stod(dark.substr(at))}}), "");
}

TEST(Preflight, ALampInRockLightsNothing) {
  std::string text = hall(kCamera + kLamp);
  text.replace(text.find("(2, 4, 0), radius"), 9, "(2, 4, 9)");
  EXPECT_NE(findings(text).find("hardly any light reaches the picture"), std::string::npos);
}

TEST(Preflight, ACameraThatLooksAwaySeesNothing) {
  const std::string far =
      findings(hall("camera main { eye (0, 90, 0)  target (0, 200, 1) }\n" + kLamp));
  EXPECT_NE(far.find("the camera sees nothing within 50 m: the scene is around (0, 3, 0)"),
            far.npos)
      << far;
}

TEST(Preflight, AViewOfALargeModelFromOutsideIsFine) {
  const auto seen_from = [](const std::string& eye) {
    return findings(
        "volume model = level_set(box(size: (120, 20, 60)), voxel: 4m)\n"
        "mesh wall on model {}\nobject cave on wall {}\nlight dome = sky()\n"
        "camera main { eye " +
        eye + "  target (0, 0, 0) }\n");
  };
  EXPECT_EQ(seen_from("(30, 80, 140)"), "");
  EXPECT_NE(seen_from("(300, 800, 1400)").find("the camera sees nothing within"),
            std::string::npos);
}

TEST(Preflight, TheInspectionDoesNotChangeThePicture) {
  const loading::Loaded loaded = loading::load_text(hall(kCamera + kLamp), "t.vug");
  building::Builder builder(loaded.shot);
  picture::PictureOptions options;
  options.settings = {{"size", List{16, 9}}, {"spp", 2}};
  const auto plan = picture::plan_picture(loaded.shot, options);
  picture::RenderOptions tested;
  int calls = 0;
  tested.inspect = [&](const render::PreparedRender& prepared) {
    preflight(prepared, plan.render.settings), ++calls;
  };
  EXPECT_EQ(picture::render_picture(builder, plan, tested).image,
            picture::render_picture(builder, plan).image);
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace vug::scout
