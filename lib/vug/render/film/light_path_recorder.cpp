#include <vug/render/materials/material_input.h>
#include <vug/render/light.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/prepared_scene.h>

#include <algorithm>

namespace vug::render {

const std::vector<std::string>& part_names() {
  static const std::vector<std::string> names = {
      "emission",          "diffuse_direct",      "diffuse_indirect",      "specular_direct",
      "specular_indirect", "transmission_direct", "transmission_indirect", "volume_direct",
      "volume_indirect"};
  return names;
}

void Tally::clear() {
  std::fill(colours_.begin(), colours_.end(), Rgb(0.0f));
  notes_.clear();
}

void Tally::read(const Surface& surface, const Material& material) {
  size_t next = plan_.lights();
  if (plan_.wetness) colours_[next++] = Rgb(material.wetness(surface), 0, 0);
  if (plan_.attributes.empty()) return;
  const SurfacePoint place(surface);
  for (const std::string& name : plan_.attributes) {
    const auto value = place.eval_point().attributes->read(name);
    colours_[next++] = value ? Rgb(*value) : Rgb(0.0f);
  }
}

void Tally::note(uint32_t group, const Rgb& light, const Rgb& diffuse) {
  notes_.push_back({group, light, diffuse});
}

void Tally::note_sky(const World& world, uint32_t object, const Vec3f& direction, const Rgb& weight,
                     const Rgb& diffuse_weight) {
  const LightSet& lights = world.lights();
  for (const LightId id : lights.skies()) {
    if (!lights.reaches(id, object)) continue;
    const Rgb light = lights.sky(id).eval_environment(direction);
    note(lights.group(id), light * weight, light * diffuse_weight);
  }
}

void Tally::settle_met(int depth, const Rgb& scale) {
  if (plan_.parts)
    for (const Note& n : notes_) {
      if (depth == 0)
        part(LightPart::emission) += n.light * scale;
      else
        file(n.light * scale, depth == 1);
    }
  settle_groups(scale);
}

void Tally::settle_surface(int depth, const Rgb& scale) {
  if (plan_.parts)
    for (const Note& n : notes_) {
      if (depth == 0) {
        part(LightPart::diffuse_direct) += n.diffuse * scale;
        part(LightPart::specular_direct) += (n.light - n.diffuse) * scale;
      } else {
        file(n.light * scale, false);
      }
    }
  settle_groups(scale);
}

void Tally::settle_medium(int depth, const Rgb& scale) {
  if (plan_.parts)
    for (const Note& n : notes_) {
      if (depth == 0)
        part(LightPart::volume_direct) += n.light * scale;
      else
        file(n.light * scale, false);
    }
  settle_groups(scale);
}

void Tally::settle_groups(const Rgb& scale) {
  if (plan_.groups > 0)
    for (const Note& n : notes_) {
      const auto found = plan_.group_of.find(n.group);
      if (found != plan_.group_of.end())
        colours_[plan_.lights() - plan_.groups + found->second] += n.light * scale;
    }
  notes_.clear();
}

void Tally::turned_in_medium() {
  diffuse_ = Rgb(0.0f);
  other_ = LightPart::volume_direct;
}

void Tally::turned_at_surface(bool through, const Rgb& weight, const Rgb& diffuse) {
  const auto share = [](float part_of, float whole) { return whole > 0 ? part_of / whole : 0; };
  diffuse_ = through ? Rgb(0.0f)
                     : Rgb(share(diffuse.x, weight.x), share(diffuse.y, weight.y),
                           share(diffuse.z, weight.z));
  other_ = through ? LightPart::transmission_direct : LightPart::specular_direct;
}

void Tally::file(const Rgb& light, bool direct) {
  const size_t later = direct ? 0 : 1;
  const Rgb diffuse = light * diffuse_;
  colours_[static_cast<size_t>(LightPart::diffuse_direct) + later] += diffuse;
  colours_[static_cast<size_t>(other_) + later] += light - diffuse;
}

}  // namespace vug::render
