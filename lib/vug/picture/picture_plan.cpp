// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/image/denoise.h>
#include <vug/picture/picture_plan.h>
#include <vug/shot/selection.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace vug::picture {
namespace {

template <class Named>
const auto& find_named(const Named& items, const std::string& name, const std::string& what) {
  std::vector<std::string> names;
  for (const auto& item : items) {
    if (item.name == name) return item;
    names.push_back(item.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("the scene has no {} '{}'", what, name), {},
              suggestion(name, names));
}

shot::RenderPlan render_block(const shot::Shot& shot, const std::string& name) {
  if (!name.empty()) return find_named(shot.renders, name, "render");
  return shot.renders.empty() ? shot::RenderPlan() : shot.renders.front();
}

/// The camera that `name` or else the render block chooses.
render::CameraPtr find_camera(const shot::Shot& shot, const shot::RenderPlan& plan,
                              const std::string& name) {
  if (!name.empty()) return find_named(shot.cameras, name, "camera").camera;
  if (plan.settings.camera || shot.cameras.empty()) return plan.settings.camera;
  const auto same =
      std::find_if(shot.cameras.begin(), shot.cameras.end(),
                   [&](const shot::CameraPlan& each) { return each.name == plan.name; });
  return (same == shot.cameras.end() ? shot.cameras.front() : *same).camera;
}

/// Adds the layers that denoising needs to those that the settings list. A picture that lists none
/// has them anyway.
void add_denoising_layers(shot::RenderSettings& settings) {
  std::vector<std::string>& layers = settings.layers;
  const auto has = [&](const char* name) {
    return std::find(layers.begin(), layers.end(), name) != layers.end();
  };
  if (!settings.denoise || layers.empty() || has("all")) return;
  for (const std::string& needed : image::denoising_layers())
    if (!has(needed.c_str())) layers.push_back(needed);
}

bool is_true(const NamedValues& values, const std::string& name) {
  return std::any_of(values.begin(), values.end(), [&](const auto& each) {
    const bool* value = each.first == name ? each.second.template get<bool>() : nullptr;
    return value && *value;
  });
}

/// A hash of the settings, except those that the metadata contain themselves. The digest of the
/// text covers the values in the scene, so that a new setting matters only if an option replaces
/// it. The first settings have a form of their own, which is older than the table.
std::string settings_hash(const shot::Shot& shot, const PicturePlan& plan) {
  static const std::set<std::string> kOlder = {
      "size", "spp",     "noise",  "exposure", "openings",      "half", "multi_part", "tiled",
      "deep", "denoise", "layers", "crop",     "working_space", "view", "display"};
  const shot::RenderSettings& set = plan.render.settings;
  const NamedValues& replaced = plan.options.settings;
  std::vector<std::string> texts = {
      plan.render.name,
      camera_name(shot, plan.render),
      set.view,
      set.display,
      plan.options.config.string(),
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", fmt::join(set.size, "x"), set.noise,
                  to_string(ValueTraits<shot::Exposure>::write(set.exposure)), set.openings,
                  set.half, set.multi_part, set.tiled, set.denoise, is_true(replaced, "deep"),
                  plan.options.eye, fmt::join(set.layers, ","), fmt::join(set.crop, ","))};
  for (const auto& [name, value] : replaced)
    if (!kOlder.count(name)) texts.push_back(fmt::format("{}={}", name, to_string(value)));
  Hasher hash;
  hash.add_value(shot.text_digest);
  for (const std::string& text : texts) hash.add_value(text.size()).add(text);
  return hash.finish().hex();
}

}  // namespace

std::string PicturePlan::option_for(const std::string& setting) const {
  for (const auto& replaced : options.settings)
    if (replaced.first == setting) return "--" + setting;
  return "";
}

PicturePlan plan_picture(const shot::Shot& shot, const PictureOptions& options) {
  PicturePlan plan{render_block(shot, options.render), options, nullptr};
  plan.render.settings = shot::with_overrides(plan.render.settings, options.settings);
  shot::apply_quality(plan.render.settings, plan.render.stated, options.settings);
  add_denoising_layers(plan.render.settings);
  plan.render.settings.camera = find_camera(shot, plan.render, options.camera);
  for (const shot::SelectionFault& fault :
       shot::find_selection_faults(shot, plan.render.settings)) {
    const std::string option = plan.option_for(fault.setting);
    throw Error(ErrorCode::bad_input, option + (option.empty() ? "" : ": ") + fault.message,
                option.empty() ? plan.render.where : SourceLocation(), fault.hint);
  }
  plan.shown = shot::selected_part(shot, plan.render.settings);
  return plan;
}

render::CameraPtr camera_in(const shot::Shot& shot, const PicturePlan& plan) {
  return find_camera(shot, render_block(shot, plan.options.render), plan.options.camera);
}

std::string camera_name(const shot::Shot& shot, const shot::RenderPlan& plan) {
  const render::CameraPtr& camera = plan.settings.camera;
  for (const shot::CameraPlan& each : shot.cameras)
    if (camera ? each.camera == camera : each.name == plan.name) return each.name;
  return shot.cameras.empty() ? "" : shot.cameras.front().name;
}

bool is_stereo(const PicturePlan& plan) {
  const render::CameraPtr& camera = plan.render.settings.camera;
  return camera && camera->stereo_view(-1);
}

image::Metadata identifying_metadata(const shot::Shot& shot, const PicturePlan& plan) {
  const shot::RenderSettings& settings = plan.render.settings;
  image::Metadata all = {{"vug:recipe", shot.recipe},
                         {"vug:version", VUG_VERSION},
                         {"vug:seed", std::to_string(plan.options.seed.value_or(shot.seed))},
                         {"vug:working_space", image::info(settings.working_space).name},
                         {"vug:spp", std::to_string(settings.spp)},
                         {"vug:settings", settings_hash(shot, plan)}};
  if (shot.animated) all.emplace_back("vug:frame", fmt::format("{}", shot.frame));
  return all;
}

}  // namespace vug::picture
