// SPDX-License-Identifier: Apache-2.0
#include <vug/image/io.h>
#include <vug/viewport/preview_renderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vug::viewport {
namespace {

/// The coarsest picture has at least this number of pixels on its longer side.
constexpr int kMinSide = 128;
/// Samples of the finest picture without light, where only edges and creases are noisy.
constexpr int kPlainSamples = 16;

int divided(int size, int divider) { return std::max(1, size / divider); }

std::vector<uint8_t> codes_of(const Preview& picture) {
  const picture::PictureOutput& output = picture.scene.scene->job.output;
  return image::display_codes(*picture.light,
                              picture.mode == Mode::path
                                  ? view_options(picture.display, output, *picture.light)
                                  : image::plain_view());
}

}  // namespace

void PreviewRenderer::set_scene(PreviewScenePtr scene) {
  scene_ = std::move(scene);
  is_new_ = true;
}

std::vector<PreviewStep> PreviewRenderer::steps(const PreviewRequest& request, double first) const {
  const int side = std::max(request.width, request.height);
  const auto seconds = [&](int divider) {
    return seconds_per_pixel_ * divided(request.width, divider) * divided(request.height, divider);
  };
  int divider = std::clamp(side / kMinSide, 1, 4);
  if (seconds_per_pixel_ > 0)
    for (divider = 1; seconds(divider) > first && side / (divider + 1) >= kMinSide;) ++divider;
  std::vector<PreviewStep> out{{divider, 1, false}};
  if (divider > 3) out.push_back({2, 1, false});
  if (divider > 1) out.push_back({1, 1, false});
  const int last = request.mode == Mode::path && scene_ ? scene_->job.options.spp : kPlainSamples;
  for (int samples = 4; samples < last; samples *= 4) out.push_back({1, samples, true});
  if (last > 1) out.push_back({1, last, true});
  return out;
}

const render::CameraPtr& PreviewRenderer::camera(const PreviewRequest& request) {
  if (!request.view) return scene_->job.scene.camera;
  if (!camera_ || !(camera_view_ == request.view)) {
    camera_view_ = request.view;
    camera_ = camera_of(*request.view);
  }
  return camera_;
}

render::Options PreviewRenderer::options(const PreviewRequest& request,
                                         const PreviewStep& step) const {
  render::Options out = scene_->job.options;
  out.width = divided(request.width, step.divider);
  out.height = divided(request.height, step.divider);
  if (const auto preview = preview_integrator(request.mode, step.occlusion)) {
    out.integrator = preview;
    out.openings = false;
    out.bright_edges = false;
    out.spp = kPlainSamples;
  }
  return out;
}

Preview PreviewRenderer::render(const PreviewRequest& request, const PreviewStep& step, bool last,
                                Progress& progress) {
  const render::CameraPtr& own = camera(request);
  if (is_new_) {
    render::Scene scene = scene_->job.scene;
    scene.camera = own;
    session_.set_scene(std::move(scene));
    is_new_ = false;
  } else if (session_.scene().camera != own) {
    session_.set_camera(own);
  }
  if (request.mode == Mode::path && step.divider > 1) {
    // Guiding and portals are learned for the whole picture: a coarse one would learn too little.
    session_.set_options(options(request, {}));
    session_.prepared(progress);
  }
  session_.set_options(options(request, step));
  const render::PreparedRender& prepared = session_.prepared(progress);
  const auto begin = std::chrono::steady_clock::now();
  session_.proceed(static_cast<uint32_t>(step.samples), progress);
  Preview out;
  out.light = std::make_shared<const image::Image>(session_.image());
  out.width = out.light->width, out.height = out.light->height;
  if (step.samples == 1) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    seconds_per_pixel_ = taken.count() / static_cast<double>(out.light->pixel_count());
  }
  out.mode = request.mode;
  out.display = request.display;
  out.view = request.view.value_or(scene_->home);
  out.samples = step.samples;
  out.complete = last;
  out.scene = {scene_, prepared.world, own, static_cast<double>(request.width) / request.height};
  out.rgb = codes_of(out);
  return out;
}

Preview PreviewRenderer::displayed(const Preview& picture, const DisplayChoice& display) {
  Preview out = picture;
  out.display = display;
  out.rgb = codes_of(out);
  return out;
}

}  // namespace vug::viewport
