// SPDX-License-Identifier: Apache-2.0
// Previews: all modes from one preparation, bright enough to read, the same bytes for any number of
// threads.
#include "scene.h"

#include <vug/base/parallel.h>
#include <vug/viewport/preview_renderer.h>

#include <set>

namespace vug::viewport {
namespace {

/// The value of a pixel, as the mean of its channels.
double at(const Preview& picture, double x, double y) {
  const auto column = static_cast<size_t>(x * picture.width);
  const auto row = static_cast<size_t>(y * picture.height);
  const size_t index = 3 * (row * static_cast<size_t>(picture.width) + column);
  return (picture.rgb[index] + picture.rgb[index + 1] + picture.rgb[index + 2]) / 3.0;
}

PreviewRequest request_of(Mode mode) { return {std::nullopt, mode, 64, 36}; }

TEST(PreviewRenderer, ClayIsReadableWithoutAnyLightInTheScene) {
  PreviewRenderer renderer;
  renderer.set_scene(build(scene_text()));
  const Preview picture = renderer.render(request_of(Mode::clay), {1, 16, true}, true);
  ASSERT_EQ(picture.rgb.size(), 3u * 64 * 36);
  EXPECT_GT(at(picture, 0.5, 0.5), 150);
  EXPECT_LT(at(picture, 0.5, 0.5), 250);
  // The rim of the ball, where the headlight is weak, has the light of the sky.
  EXPECT_GT(at(picture, 0.5, 0.34), 100);
  EXPECT_LT(at(picture, 0.02, 0.02), 110) << "the background";
}

TEST(PreviewRenderer, AllModesShareOnePreparation) {
  PreviewRenderer renderer;
  renderer.set_scene(build(scene_text()));
  std::set<std::vector<uint8_t>> pictures;
  for (const Mode mode : {Mode::clay, Mode::normals, Mode::ids, Mode::path})
    pictures.insert(renderer.render(request_of(mode), {1, 1, false}, false).rgb);
  EXPECT_EQ(pictures.size(), 4u);
  EXPECT_EQ(renderer.counters().scenes, 1u);
}

TEST(PreviewRenderer, AMotionBuildsNothing) {
  PreviewRenderer renderer;
  const PreviewScenePtr scene = build(scene_text());
  renderer.set_scene(scene);
  PreviewRequest request = request_of(Mode::clay);
  const std::vector<uint8_t> own = renderer.render(request, {1, 1, false}, false).rgb;
  for (int i = 0; i < 5; ++i) {
    request.view = orbit(scene->home, 0.2 * i, 0.1);
    EXPECT_NE(renderer.render(request, {2, 1, false}, false).rgb, own);
  }
  request.view.reset();
  EXPECT_EQ(renderer.render(request, {1, 1, false}, false).rgb, own);
  EXPECT_EQ(renderer.counters().scenes, 1u);
}

TEST(PreviewRenderer, TheBytesDoNotDependOnThreads) {
  const PreviewScenePtr scene = build(scene_text());
  for (const Mode mode : {Mode::clay, Mode::ids, Mode::path}) {
    std::set<std::vector<uint8_t>> pictures;
    for (const int threads : {1, 2, 7})
      with_threads(threads, [&] {
        PreviewRenderer renderer;
        renderer.set_scene(scene);
        renderer.render(request_of(mode), {2, 1, false}, false);
        pictures.insert(renderer.render(request_of(mode), {1, 4, true}, true).rgb);
      });
    EXPECT_EQ(pictures.size(), 1u) << mode_names()[static_cast<size_t>(mode)];
  }
}

TEST(PreviewRenderer, StepsGoFromCoarseToComplete) {
  PreviewRenderer renderer;
  renderer.set_scene(build(scene_text()));
  const PreviewRequest request{std::nullopt, Mode::clay, 1280, 720};
  const std::vector<PreviewStep> steps = renderer.steps(request);
  ASSERT_GT(steps.size(), 2u);
  EXPECT_EQ(steps.front().divider, 4);
  EXPECT_EQ(steps.back(), (PreviewStep{1, 16, true}));
  for (size_t i = 1; i < steps.size(); ++i) {
    EXPECT_LE(steps[i].divider, steps[i - 1].divider);
    EXPECT_GE(steps[i].samples, steps[i - 1].samples);
  }
  renderer.render({std::nullopt, Mode::clay, 64, 36}, {1, 1, false}, false);
  EXPECT_EQ(renderer.steps(request, 1e9).front().divider, 1) << "there is time for all pixels";
  EXPECT_EQ(renderer.steps(request, 1e-9).front().divider, 10) << "128 pixels remain";
}

TEST(PreviewModes, HaveNames) {
  for (const std::string& name : mode_names())
    EXPECT_EQ(mode_names()[static_cast<size_t>(mode_of(name))], name);
  EXPECT_THROW(mode_of("wire"), Error);
  EXPECT_EQ(preview_integrator(Mode::path, true), nullptr);
}

}  // namespace
}  // namespace vug::viewport
