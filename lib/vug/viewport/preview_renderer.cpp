// SPDX-License-Identifier: Apache-2.0
#include <vug/image/denoise.h>
#include <vug/image/io.h>
#include <vug/viewport/preview_renderer.h>
#include <vug/viewport/scaled_codes.h>
#include <vug/viewport/shown_layer.h>

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
  if (picture.mode != Mode::path) return image::display_codes(*picture.light, image::plain_view());
  const DisplayChoice& display = picture.display;
  // The exposure is that of the picture, whichever layer is shown.
  const image::ViewOptions view =
      view_options(display, picture.scene.scene->job.output, *picture.metered);
  if (!display.layer.empty())
    if (const auto layer = shown_layer(*picture.light, display.layer))
      return image::display_codes(layer->image, layer->is_light ? view : image::plain_view());
  return image::display_codes(
      display.denoise && picture.denoised ? *picture.denoised : *picture.light, view);
}

/// Writes the display values of the region into the picture.
void show_light(Preview& picture) {
  std::vector<uint8_t> codes = codes_of(picture);
  const render::Region& region = picture.region;
  if (codes.size() == picture.rgb.size() || picture.rgb.empty()) {
    picture.rgb = std::move(codes);
    return;
  }
  const auto row = static_cast<std::ptrdiff_t>(3) * region.width();
  for (int y = region.y0; y < region.y1; ++y) {
    const auto from = codes.begin() + (y - region.y0) * row;
    std::copy(
        from, from + row,
        picture.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width + region.x0));
  }
}

}  // namespace

render::Region pixels_of(const RegionBox& box, int width, int height) {
  const auto first = [](double at, int size) {
    return std::clamp(static_cast<int>(std::floor(at * size)), 0, size - 1);
  };
  const auto last = [](double at, int begin, int size) {
    return std::clamp(static_cast<int>(std::ceil(at * size)), begin + 1, size);
  };
  render::Region out;
  out.x0 = first(std::min(box.x0, box.x1), width);
  out.y0 = first(std::min(box.y0, box.y1), height);
  out.x1 = last(std::max(box.x0, box.x1), out.x0, width);
  out.y1 = last(std::max(box.y0, box.y1), out.y0, height);
  return out;
}

void PreviewRenderer::set_scene(PreviewScenePtr scene) {
  scene_ = std::move(scene);
  is_new_ = true;
}

std::vector<PreviewStep> PreviewRenderer::steps(const PreviewRequest& request, double first) const {
  const int side = std::max(request.width, request.height);
  const auto seconds = [&](int divider) {
    return seconds_per_pixel_ * static_cast<double>(pixels_of(request.region.value_or(RegionBox()),
                                                              divided(request.width, divider),
                                                              divided(request.height, divider))
                                                        .pixels());
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
  // The crop of the text is for its own size.
  out.crop = {};
  if (request.region) out.crop = pixels_of(*request.region, out.width, out.height);
  if (const auto preview = preview_integrator(request.mode, step.occlusion)) {
    out.integrator = preview;
    out.aovs = render::plan_aovs({"beauty"}, {});
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
  const render::Options now = options(request, step);
  out.width = now.width, out.height = now.height;
  out.region = request.region ? now.crop : render::Region{0, 0, out.width, out.height};
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
  if (step.samples == 1) denoised_.reset(), denoised_samples_ = 0;
  out.denoised = denoised_;
  out.denoised_samples = denoised_samples_;
  out.metered = request.region && backdrop_.light ? backdrop_.light : out.light;
  if (request.region)
    out.rgb = scaled_codes(backdrop_.rgb, backdrop_.width, backdrop_.height, out.width, out.height);
  show_light(out);
  if (!request.region)
    backdrop_ = {out.width, out.height, out.rgb, out.mode == Mode::path ? out.light : nullptr};
  return out;
}

Preview PreviewRenderer::denoised(const Preview& picture, Progress& progress) {
  image::Image smooth = image::denoise(*picture.light, {}, progress);
  smooth.channels = {"R", "G", "B"};
  denoised_ = std::make_shared<const image::Image>(std::move(smooth));
  denoised_samples_ = picture.samples;
  Preview out = picture;
  out.denoised = denoised_;
  out.denoised_samples = denoised_samples_;
  show_light(out);
  return out;
}

Preview PreviewRenderer::displayed(const Preview& picture, const DisplayChoice& display) {
  Preview out = picture;
  out.display = display;
  show_light(out);
  return out;
}

}  // namespace vug::viewport
