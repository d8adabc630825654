// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/film/surface_aov.h>
#include <vug/render/light.h>
#include <vug/render/materials/material_input.h>
#include <vug/render/prepared_scene.h>

#include <algorithm>

namespace vug::render {

const std::vector<LightComponentInfo>& light_components() {
  static const std::vector<LightComponentInfo> all = {
      {"emission", "Light of emitters that the camera sees directly."},
      {"diffuse_direct", "Direct light reflected by the diffuse lobes of the first surface."},
      {"diffuse_indirect", "Indirect light reflected by the diffuse lobes of the first surface."},
      {"specular_direct", "Direct light reflected by the other lobes of the first surface."},
      {"specular_indirect", "Indirect light reflected by the other lobes of the first surface."},
      {"transmission_direct", "Direct light transmitted by the first surface."},
      {"transmission_indirect", "Indirect light transmitted by the first surface."},
      {"volume_direct",
       "Direct light scattered towards the camera by the medium in front of the first surface."},
      {"volume_indirect",
       "Indirect light scattered towards the camera by the medium in front of the first surface."},
  };
  return all;
}

void LightPathRecorder::clear() {
  std::fill(colours_.begin(), colours_.end(), Rgb(0.0f));
  records_.clear();
}

void LightPathRecorder::read_surface(const Surface& surface, const Material& material) {
  size_t next = plan_.lights();
  for (const SurfaceAov* aov : plan_.surface) colours_[next++] = aov->read(surface, material);
  if (plan_.attributes.empty()) return;
  const SurfacePoint point(surface);
  for (const std::string& name : plan_.attributes) {
    const auto value = point.eval_point().attributes->read(name);
    colours_[next++] = value ? Rgb(*value) : Rgb(0.0f);
  }
}

void LightPathRecorder::record(uint32_t group, const Rgb& light, const Rgb& diffuse) {
  records_.push_back({group, light, diffuse});
}

void LightPathRecorder::record_environment(const PreparedScene& world, uint32_t object,
                                           const Vec3f& direction, const Rgb& weight,
                                           const Rgb& diffuse_weight) {
  const LightSet& lights = world.lights();
  for (const LightId id : lights.skies()) {
    if (!lights.reaches(id, object)) continue;
    const Rgb light = lights.sky(id).eval_environment(direction);
    record(lights.group(id), light * weight, light * diffuse_weight);
  }
}

void LightPathRecorder::flush_emission(int depth, const Rgb& scale) {
  if (plan_.components)
    for (const Record& r : records_) {
      if (depth == 0)
        component(LightComponent::emission) += r.light * scale;
      else
        add_scattered(r.light * scale, depth == 1);
    }
  flush_groups(scale);
}

void LightPathRecorder::flush_surface(int depth, const Rgb& scale) {
  if (plan_.components)
    for (const Record& r : records_) {
      if (depth == 0) {
        component(LightComponent::diffuse_direct) += r.diffuse * scale;
        component(LightComponent::specular_direct) += (r.light - r.diffuse) * scale;
      } else {
        add_scattered(r.light * scale, false);
      }
    }
  flush_groups(scale);
}

void LightPathRecorder::flush_medium(int depth, const Rgb& scale) {
  if (plan_.components)
    for (const Record& r : records_) {
      if (depth == 0)
        component(LightComponent::volume_direct) += r.light * scale;
      else
        add_scattered(r.light * scale, false);
    }
  flush_groups(scale);
}

void LightPathRecorder::flush_groups(const Rgb& scale) {
  if (plan_.groups > 0)
    for (const Record& r : records_) {
      const auto found = plan_.group_of.find(r.group);
      if (found != plan_.group_of.end())
        colours_[plan_.lights() - plan_.groups + found->second] += r.light * scale;
    }
  records_.clear();
}

void LightPathRecorder::scattered_in_medium() {
  diffuse_ = Rgb(0.0f);
  other_ = LightComponent::volume_direct;
}

void LightPathRecorder::scattered_at_surface(bool through, const Rgb& weight, const Rgb& diffuse) {
  const auto share = [](float part_of, float whole) { return whole > 0 ? part_of / whole : 0; };
  diffuse_ = through ? Rgb(0.0f)
                     : Rgb(share(diffuse.x, weight.x), share(diffuse.y, weight.y),
                           share(diffuse.z, weight.z));
  other_ = through ? LightComponent::transmission_direct : LightComponent::specular_direct;
}

void LightPathRecorder::add_scattered(const Rgb& light, bool direct) {
  const size_t later = direct ? 0 : 1;
  const Rgb diffuse = light * diffuse_;
  colours_[static_cast<size_t>(LightComponent::diffuse_direct) + later] += diffuse;
  colours_[static_cast<size_t>(other_) + later] += light - diffuse;
}

}  // namespace vug::render
