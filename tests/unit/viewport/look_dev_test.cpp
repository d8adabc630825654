// SPDX-License-Identifier: Apache-2.0
// Look development: the display changes without samples, pauses keep them, and the complete picture
// is that of a render.
#include "scene.h"

#include <vug/image/denoise.h>
#include <vug/picture/picture.h>
#include <vug/viewport/inspect.h>
#include <vug/viewport/screen_view.h>
#include <vug/viewport/shown_layer.h>
#include <vug/viewport/viewport.h>

#include <limits>

namespace vug::viewport {
namespace {

/// A scene with much light, a bright lamp in the picture, an opening to the sky and guiding.
std::string lit_text() {
  return scene_text() +
         "light near = sphere(center: (-1, 1, 1), radius: 20cm, radiance: (9, 8, 6))\n"
         "light spot = spot(center: (0, 3, 1), direction: (0, -2, 0), lumen: 900)\n"
         "light sky = sky(radiance: (0.4, 0.5, 0.6))\n";
}

class LookDev : public testing::Test {
 protected:
  void SetUp() override {
    viewport_.set_size(64, 36);
    viewport_.set_mode(Mode::path);
    viewport_.set_text(lit_text());
    viewport_.wait();
    ASSERT_TRUE(viewport_.status().picture) << viewport_.status().report;
  }
  ViewportStatus after() {
    viewport_.wait();
    return viewport_.status();
  }
  Viewport viewport_{"scene.vug", {}};
};

TEST_F(LookDev, TheCompletePictureIsThatOfARender) {
  const PreviewPtr shown = viewport_.status().picture;
  ASSERT_TRUE(shown->complete);
  EXPECT_EQ(shown->samples, 4) << "the spp of the render block";
  LiveText live("scene.vug", {});
  ASSERT_TRUE(live.load(lit_text(), std::make_shared<Progress>())) << live.report();
  picture::PictureOptions options;
  options.settings = {{"spp", 4}};
  const auto rendered =
      picture::render_picture(live.builder(), picture::plan_picture(live.loaded().shot, options));
  ASSERT_TRUE(rendered.image);
  const std::vector<std::string> colours = {"R", "G", "B"};
  EXPECT_EQ(shown->light->select(colours), rendered.image->select(colours));
}

TEST_F(LookDev, TheDisplayChangesWithoutSamples) {
  const ViewportStatus before = viewport_.status();
  viewport_.set_display({1.5, ""});
  const ViewportStatus bright = after();
  EXPECT_EQ(bright.counters.samples, before.counters.samples);
  EXPECT_EQ(bright.counters.pictures, before.counters.pictures + 1);
  EXPECT_EQ(bright.picture->light, before.picture->light);
  EXPECT_TRUE(bright.picture->complete);
  size_t brighter = 0, darker = 0;
  for (size_t i = 0; i < bright.picture->rgb.size(); ++i) {
    brighter += bright.picture->rgb[i] > before.picture->rgb[i];
    darker += bright.picture->rgb[i] < before.picture->rgb[i];
  }
  EXPECT_GT(brighter, bright.picture->rgb.size() / 2);
  EXPECT_EQ(darker, 0u);
  viewport_.set_display({0, "standard"});
  EXPECT_NE(after().picture->rgb, before.picture->rgb);
  viewport_.set_display({});
  const ViewportStatus restored = after();
  EXPECT_EQ(restored.picture->rgb, before.picture->rgb);
  EXPECT_EQ(restored.counters.samples, before.counters.samples);
  EXPECT_THROW(view_options({0, "nothing"}, restored.picture->scene.scene->job.output,
                            *restored.picture->light),
               Error);
}

TEST_F(LookDev, APauseKeepsTheSamples) {
  const ViewportStatus whole = viewport_.status();
  viewport_.set_paused(true);
  viewport_.set_view(orbit(viewport_.view(), 0.3, 0));
  const ViewportStatus coarse = after();
  EXPECT_TRUE(coarse.paused);
  EXPECT_FALSE(coarse.picture->complete);
  EXPECT_EQ(coarse.picture->samples, 1) << "the coarsest picture of the new view";
  viewport_.set_display({1, ""});
  const ViewportStatus bright = after();
  EXPECT_EQ(bright.counters.samples, coarse.counters.samples) << "a display needs no samples";
  EXPECT_NE(bright.picture->rgb, coarse.picture->rgb);
  viewport_.set_paused(false);
  const ViewportStatus complete = after();
  EXPECT_TRUE(complete.picture->complete);
  // Both views have 64 x 36 pixels; the second was not begun again after the pause.
  const uint64_t first = whole.counters.samples;
  EXPECT_EQ(complete.counters.samples, 2 * first);
}

TEST_F(LookDev, ARegionRendersItsPixelsOnly) {
  const ViewportStatus whole = after();
  viewport_.set_region(RegionBox{0.25, 0.5, 0.5, 0.75});
  const ViewportStatus part = after();
  ASSERT_TRUE(part.picture->complete);
  const render::Region expected{16, 18, 32, 27};
  EXPECT_EQ(part.picture->region, expected);
  EXPECT_EQ(part.counters.samples - whole.counters.samples, expected.pixels() * 4);
  EXPECT_EQ(part.picture->light->pixel_count(), expected.pixels());
  // The light is that of the whole picture, since both have the same samples and learned light.
  const std::vector<std::string> colours = {"R", "G", "B"};
  const image::Image all = whole.picture->light->select(colours),
                     some = part.picture->light->select(colours);
  for (int y = 0; y < some.height; ++y)
    for (int x = 0; x < some.width; ++x)
      for (size_t c = 0; c < 3; ++c)
        EXPECT_EQ(some.at(x, y, c), all.at(x + expected.x0, y + expected.y0, c)) << x << " " << y;
  EXPECT_EQ(part.picture->rgb, whole.picture->rgb) << "the other pixels stay";

  const PixelReport inside = inspect(*part.picture, 0.26, 0.51),
                    outside = inspect(*part.picture, 0, 0);
  ASSERT_TRUE(inside.light);
  EXPECT_EQ(inside.light->x, static_cast<double>(all.at(16, 18, 0)));
  EXPECT_FALSE(outside.light);
  EXPECT_NE(describe(outside).find("outside of the region"), std::string::npos);

  // Another display changes the region only; the end of the region renders all pixels.
  viewport_.set_display({2, ""});
  const ViewportStatus bright = after();
  EXPECT_EQ(bright.counters.samples, part.counters.samples);
  EXPECT_EQ(bright.picture->rgb[0], whole.picture->rgb[0]);
  EXPECT_NE(bright.picture->rgb, whole.picture->rgb);
  viewport_.set_display({});
  viewport_.set_region(std::nullopt);
  EXPECT_EQ(after().picture->rgb, whole.picture->rgb);
}

TEST_F(LookDev, ARegionHasTheAutomaticExposureOfTheWholePicture) {
  std::string text = lit_text();
  text.replace(text.find("exposure 0"), 10, "exposure auto");
  viewport_.set_text(text);
  const ViewportStatus whole = after();
  viewport_.set_region(RegionBox{0, 0, 0.25, 0.25});
  EXPECT_EQ(after().picture->rgb, whole.picture->rgb);
}

TEST_F(LookDev, ThePictureIsDenoisedFromTheSamplesThatExist) {
  const ViewportStatus noisy = after();
  DisplayChoice display;
  display.denoise = true;
  viewport_.set_display(display);
  const ViewportStatus smooth = after();
  ASSERT_TRUE(smooth.picture->denoised);
  EXPECT_EQ(smooth.counters.samples, noisy.counters.samples);
  EXPECT_EQ(smooth.picture->denoised_samples, 4);
  EXPECT_TRUE(smooth.picture->complete);
  EXPECT_EQ(smooth.picture->light, noisy.picture->light);
  EXPECT_NE(smooth.picture->rgb, noisy.picture->rgb);

  // It is the layer `denoised` of the render with --denoise.
  LiveText live("scene.vug", {});
  ASSERT_TRUE(live.load(lit_text(), std::make_shared<Progress>())) << live.report();
  picture::PictureOptions options;
  options.settings = {{"denoise", true}};
  const auto rendered =
      picture::render_picture(live.builder(), picture::plan_picture(live.loaded().shot, options));
  ASSERT_TRUE(rendered.image);
  EXPECT_EQ(smooth.picture->denoised->pixels, image::denoise(*rendered.image).pixels);

  viewport_.set_display({});
  const ViewportStatus restored = after();
  EXPECT_EQ(restored.picture->rgb, noisy.picture->rgb);
  // Another view begins without the denoised light, and ends with its own.
  viewport_.set_display(display);
  viewport_.set_view(orbit(viewport_.view(), 0.3, 0));
  const ViewportStatus turned = after();
  EXPECT_EQ(turned.picture->denoised_samples, 4);
  EXPECT_NE(turned.picture->denoised->pixels, smooth.picture->denoised->pixels);
  // The other displays have no light.
  viewport_.set_mode(Mode::clay);
  EXPECT_EQ(after().picture->denoised, nullptr);
}

TEST_F(LookDev, APausedPictureIsDenoised) {
  DisplayChoice display;
  display.denoise = true;
  viewport_.set_paused(true);
  viewport_.set_display(display);
  EXPECT_EQ(after().picture->denoised_samples, 4);
  // One sample is too few: its variance is unknown.
  viewport_.set_view(orbit(viewport_.view(), 0.3, 0));
  const ViewportStatus coarse = after();
  EXPECT_EQ(coarse.picture->samples, 1);
  EXPECT_EQ(coarse.picture->denoised, nullptr);
}

TEST_F(LookDev, LayersAreShownFromTheSamplesThatExist) {
  const ViewportStatus beauty = after();
  const std::vector<std::string> layers = layers_to_show(*beauty.picture->light);
  ASSERT_FALSE(layers.empty());
  EXPECT_EQ(layers.front(), "beauty");
  const auto shown = [&](const std::string& name) {
    viewport_.set_display({0, "", false, name});
    const ViewportStatus now = after();
    EXPECT_EQ(now.counters.samples, beauty.counters.samples);
    return now.picture->rgb;
  };
  EXPECT_EQ(shown("beauty"), beauty.picture->rgb);
  EXPECT_EQ(shown("nothing"), beauty.picture->rgb) << "a layer that the text has no more";
  const auto middle = [](const std::vector<uint8_t>& rgb) { return &rgb[3 * (18 * 64 + 32)]; };
  // The ball faces the eye, which looks along -Z.
  const std::vector<uint8_t> normals = shown("N");
  EXPECT_GT(middle(normals)[2], 250);
  EXPECT_NEAR(middle(normals)[0], 128, 25);
  EXPECT_NE(shown("albedo"), normals);
  EXPECT_NE(shown("Z"), normals);
}

TEST(ShownLayers, NumbersReachFromBlackToWhite) {
  image::Image picture(3, 1, {"R", "G", "B", "Z", "light_key.R", "light_key.G", "light_key.B"});
  picture.at(0, 0, 3) = 2, picture.at(1, 0, 3) = 4;
  picture.at(2, 0, 3) = std::numeric_limits<float>::infinity();
  picture.at(1, 0, 4) = 7;
  const auto depth = shown_layer(picture, "Z");
  ASSERT_TRUE(depth);
  EXPECT_FALSE(depth->is_light);
  EXPECT_EQ(depth->image.at(0, 0), 0);
  EXPECT_EQ(depth->image.at(1, 0), 1);
  EXPECT_EQ(depth->image.at(2, 0, 2), 1);
  const auto group = shown_layer(picture, "light_key");
  ASSERT_TRUE(group);
  EXPECT_TRUE(group->is_light);
  EXPECT_EQ(group->image.at(1, 0), 7);
  EXPECT_FALSE(shown_layer(picture, "light_fill"));
  EXPECT_EQ(layers_to_show(picture), (std::vector<std::string>{"beauty", "Z", "light_key"}));
}

TEST(Regions, AreWholePixelsOfThePicture) {
  EXPECT_EQ(pixels_of({}, 64, 36), (render::Region{0, 0, 64, 36}));
  EXPECT_EQ(pixels_of({0.5, 0.5, 0.5, 0.5}, 64, 36), (render::Region{32, 18, 33, 19}));
  EXPECT_EQ(pixels_of({0.9, 1, 0.1, 0}, 10, 10), (render::Region{1, 0, 9, 10}))
      << "corners in any order";
  EXPECT_EQ(pixels_of({1, 1, 1, 1}, 8, 8), (render::Region{7, 7, 8, 8}));
  EXPECT_EQ(pixels_of({-3, 0.99, 9, 2}, 8, 8), (render::Region{0, 7, 8, 8}));
}

TEST_F(LookDev, PixelsReportTheirThings) {
  const PreviewPtr picture = viewport_.status().picture;
  const PixelReport ball = inspect(*picture, 0.5, 0.5);
  EXPECT_EQ(ball.x, 32);
  EXPECT_EQ(ball.y, 18);
  ASSERT_TRUE(ball.pick);
  EXPECT_EQ(ball.pick->object, "ball");
  ASSERT_TRUE(ball.material);
  EXPECT_EQ(ball.material->name, "stone");
  EXPECT_EQ(ball.material->where.line, 4);
  ASSERT_TRUE(ball.light);
  EXPECT_EQ(ball.light->x, static_cast<double>(picture->light->at(32, 18, 0)));
  EXPECT_EQ(ball.shown[0], picture->rgb[3 * (18 * 64 + 32)]);
  EXPECT_NE(describe(ball).find("object ball, material stone"), std::string::npos);
  EXPECT_FALSE(inspect(*picture, 0, 0).pick);
  EXPECT_EQ(inspect(*picture, 2, 2).x, 63) << "the nearest pixel";
}

TEST_F(LookDev, GizmosAreTheLightsAndCameras) {
  std::vector<std::string> names;
  for (const Gizmo& each : viewport_.status().picture->scene.scene->gizmos) {
    names.push_back(each.kind + " " + each.name);
    EXPECT_TRUE(each.where.known()) << each.name;
    EXPECT_EQ(each.direction.has_value(), each.name == "spot" || each.kind == "camera");
    if (each.name == "spot") {
      EXPECT_LT((*each.direction - Vec3d(0, -1, 0)).length(), 1e-6);
    }
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"light lamp", "light near", "light spot", "camera main"}));
}

TEST(Gizmos, OfMeasuredLightsHaveDirections) {
  const std::string file = VUG_DATA "/scenes/teaching/lantern.ies";
  const PreviewScenePtr scene = build(scene_text() + "light panes = ies(file: \"" + file +
                                      "\", center: (1, 2, 3), direction: (0, 0, -3))\n");
  const Gizmo& panes = scene->gizmos.at(1);
  EXPECT_EQ(panes.name, "panes");
  EXPECT_LT((panes.position - Vec3d(1, 2, 3)).length(), 1e-6);
  ASSERT_TRUE(panes.direction);
  EXPECT_LT((*panes.direction - Vec3d(0, 0, -1)).length(), 1e-6);
}

TEST(ScreenViews, ProjectAndCastRays) {
  const ScreenView view{camera_of({{0, 0, 4}, {0, 0, 0}, 1.0}), 640, 360};
  const Vec3d point(0.3, -0.2, 0.7);
  const std::optional<Vec2d> pixel = view.project(point);
  ASSERT_TRUE(pixel);
  const PixelRay ray = view.ray(*pixel);
  const Vec3d offset = point - ray.origin;
  EXPECT_LT((offset - ray.direction * offset.dot(ray.direction)).length(), 1e-5);
  // The width of 640 pixels at a distance of 4 m.
  EXPECT_NEAR(view.pixel_size({0, 0, 0}), 8 * std::tan(0.5) / 640, 1e-4);
  EXPECT_EQ(view.pixel_size({0, 0, 9}), 0) << "behind the camera";
  EXPECT_NEAR(*nearest_on_line({0, 0, 0}, {0, 2, 0}, view.ray({320, 180})), 0, 1e-5);
  EXPECT_FALSE(nearest_on_line({0, 0, 0}, {0, 0, 1}, view.ray({320, 180})));
}

}  // namespace
}  // namespace vug::viewport
