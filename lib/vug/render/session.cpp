// SPDX-License-Identifier: Apache-2.0
#include <vug/render/session.h>

#include <algorithm>
#include <utility>

namespace vug::render {
namespace {

bool same_object(const Object& a, const Object& b) {
  return a.name == b.name && a.mesh == b.mesh && a.material == b.material && a.flat == b.flat &&
         a.emission == b.emission && a.light_group == b.light_group &&
         a.material_name == b.material_name && a.solid == b.solid &&
         are_equal(a.instance, b.instance) && a.world_space_material == b.world_space_material &&
         a.surface == b.surface && a.color == b.color && a.elements == b.elements;
}

/// Whether only the cameras may differ.
bool same_world(const Scene& a, const Scene& b) {
  return a.lights == b.lights && a.medium == b.medium && a.omitted == b.omitted &&
         std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    same_object);
}

bool same_options(const Options& a, const Options& b) {
  return a.width == b.width && a.height == b.height && a.spp == b.spp && a.seed == b.seed &&
         a.max_bounces == b.max_bounces && a.tile_size == b.tile_size && a.sampler == b.sampler &&
         a.integrator == b.integrator && a.aovs == b.aovs && a.openings == b.openings &&
         a.bright_edges == b.bright_edges && a.crop == b.crop && a.motion_step == b.motion_step &&
         a.deep == b.deep && a.noise == b.noise;
}

}  // namespace

void Session::discard_picture() {
  prepared_.reset();
  state_ = RenderState();
  if (learning_ == Learning::exact) learned_.reset();
}

void Session::set_scene(Scene scene) {
  const bool world = same_world(*scene_, scene);
  if (world && scene.camera == scene_->camera) return;
  scene_ = std::make_shared<const Scene>(std::move(scene));
  discard_picture();
  if (world) return;
  is_current_ = false;
  learned_.reset();
}

void Session::set_camera(CameraPtr camera) {
  Scene scene = *scene_;
  scene.camera = std::move(camera);
  set_scene(std::move(scene));
}

void Session::set_lights(std::vector<LightPtr> lights) {
  Scene scene = *scene_;
  scene.lights = std::move(lights);
  set_scene(std::move(scene));
}

void Session::set_options(const Options& options) {
  if (same_options(options_, options)) {
    options_.threads = options.threads;
    if (prepared_) prepared_->options.threads = options.threads;
    return;
  }
  if (options_.integrator != options.integrator || options_.openings != options.openings)
    learned_.reset();
  options_ = options;
  discard_picture();
}

const PreparedRender& Session::prepared(Progress& progress) {
  if (prepared_) return *prepared_;
  if (!is_current_) {
    world_ = run_stage(progress, "BVH and lights", [&] {
      return std::make_shared<const PreparedScene>(*scene_, world_.get());
    });
    is_current_ = true;
    ++counters_.scenes;
    counters_.trees.built += world_->trees().built;
    counters_.trees.reused += world_->trees().reused;
  }
  if (!learned_) ++counters_.trainings;
  prepared_ = prepare(*scene_, options_, {learned_, std::nullopt, world_}, progress);
  learned_ = prepared_->learned;
  return *prepared_;
}

bool Session::proceed(uint32_t samples, Progress& progress, const RenderCallbacks& callbacks) {
  const PreparedRender& all = prepared(progress);
  if (state_.done.empty()) {
    state_ = begin_render(options_);
    ++counters_.restarts;
  }
  const uint64_t missing = state_.missing();
  const auto count = [&] { counters_.samples += missing - state_.missing(); };
  try {
    continue_render(all, state_, callbacks, progress, std::max(samples, 1u));
  } catch (...) {
    count();
    throw;
  }
  count();
  return state_.complete();
}

bool Session::proceed(std::chrono::duration<double> time, Progress& progress) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (true) {
    const uint32_t done =
        state_.done.empty() ? 0 : *std::min_element(state_.done.begin(), state_.done.end());
    if (proceed(std::max(1u, 2 * done), progress)) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
  }
}

image::Image Session::image() const {
  if (state_.done.empty()) return develop(begin_render(options_), options_.aovs);
  return develop(state_, options_.aovs);
}

image::DeepImage Session::deep() const { return develop(state_, *options_.deep); }

}  // namespace vug::render
