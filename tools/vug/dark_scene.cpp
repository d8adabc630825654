// SPDX-License-Identifier: Apache-2.0
#include "dark_scene.h"

#include <fmt/format.h>
#include <vug/loading/data_folders.h>
#include <vug/scout/scout.h>
#include <vug/scout/shot_text.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <cstdio>

namespace vug::cli {
namespace {

/// Whether the camera sees no sky, and has a roof.
bool is_closed(const scout::Location& location, const render::Camera& camera) {
  const scout::View view = scout::trace_view(*location.world, camera);
  const bool sky = std::any_of(view.pixels.begin(), view.pixels.end(),
                               [](const scout::Seen& each) { return each.object == scout::kSky; });
  const Vec3d eye(camera.position());
  return !sky && scout::look_along(*location.world, eye, {0, 1, 0}).object != scout::kSky &&
         scout::clearance(*location.world, eye) > 0;
}

}  // namespace

bool light_dark_scene(const PlannedPicture& picture, SceneAtFrame& scene) {
  shot::Shot& shot = scene.loaded.shot;
  const render::CameraPtr& camera = picture.plan.render.settings.camera;
  if (!shot.lights.empty() || !camera || picture.plan.render.settings.lights) return false;
  const scout::Location location = scout::prepare_location(scene.builder, picture.plan);
  if (location.lit || location.sky_shines || !is_closed(location, *camera)) return false;
  const auto folders = loading::data_folders();
  const std::vector<scout::Lamp> lamps =
      scout::choose_lamps(location, *camera, folders, {}, RandomKey(shot.seed).at("lamps"));
  if (lamps.empty()) return false;
  const std::vector<render::LightPtr> lights = scout::lights_of(lamps, folders);
  const std::vector<std::string> names = scout::lamp_names(lamps);
  for (size_t i = 0; i < lights.size(); ++i) shot.lights.emplace_back(names[i], lights[i]);
  clear_progress_bar();
  fmt::print(stderr,
             "note: the scene has no light, so the picture is lit by lamps that suit its camera. "
             "These lines keep them:\n{}",
             scout::lamps_text(lamps, "", "lamps"));
  return true;
}

}  // namespace vug::cli
