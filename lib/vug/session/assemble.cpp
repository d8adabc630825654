#include <vug/session/assemble.h>
#include <vug/session/bake.h>
#include <vug/session/cast.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace vug::session {
namespace {

Transform place_of(const render::Object& object) {
  if (!object.placing) return {};
  const render::Affine at = object.placing->at(0);
  return {Vec3d(at.x), Vec3d(at.y), Vec3d(at.z), Vec3d(at.origin)};
}

class Collector {
 public:
  explicit Collector(Assembled& out) : out_(out) {}

  void add(const render::Object& object) {
    const size_t part = part_of(object);
    exchange::Assembly& all = out_.assembly;
    const auto [known, fresh] =
        groups_.try_emplace({object.name, part, object.placing != nullptr}, all.groups.size());
    if (fresh) all.groups.push_back({object.name, part, {}});
    all.groups[known->second].places.push_back(place_of(object));
  }

 private:
  /// Objects that share a mesh and a look share a part.
  size_t part_of(const render::Object& object) {
    const Vec3f& light = object.emission;
    const auto [known, fresh] =
        parts_.try_emplace({object.mesh.get(), object.material.get(), light.x, light.y, light.z},
                           out_.assembly.parts.size());
    if (!fresh) return known->second;
    if (object.looks_by_place)
      out_.left_out.push_back(
          fmt::format("how the look of '{}' varies from place to place", object.name));
    const Baked baked = bake(object);
    out_.assembly.parts.push_back({object.name, baked.mesh, object.material_name, baked.look, {}});
    return known->second;
  }

  Assembled& out_;
  std::map<std::tuple<const void*, const void*, float, float, float>, size_t> parts_;
  std::map<std::tuple<std::string, size_t, bool>, size_t> groups_;
};

/// Width over height of the pictures that a camera takes.
double aspect_of(const Shot& shot, const CameraPlan& camera) {
  const RenderPlan* plan = shot.renders.empty() ? nullptr : &shot.renders.front();
  for (const RenderPlan& each : shot.renders)
    if (each.camera == camera.camera || each.name == camera.name) plan = &each;
  const std::vector<int> size = plan ? plan->size : RenderPlan().size;
  return static_cast<double>(size.at(0)) / size.at(1);
}

void add_cameras(const Shot& shot, Assembled& out) {
  const Box3d box = exchange::bounds(out.assembly);
  const double across = box.isEmpty() ? 0 : box.size().length();
  for (const CameraPlan& plan : shot.cameras) {
    exchange::Camera camera;
    if (!plan.camera->as_data(camera)) {
      out.left_out.push_back(fmt::format("camera '{}': it looks all round", plan.name));
      continue;
    }
    camera.name = plan.name;
    camera.aspect = aspect_of(shot, plan);
    // All of the scene lies before the far plane, wherever the camera stands in it.
    camera.far = std::max(1000.0, 4 * across);
    out.assembly.cameras.push_back(camera);
  }
}

void add_lamps(const Shot& shot, const std::vector<render::LightPtr>& lights, Assembled& out) {
  for (const render::LightPtr& light : lights) {
    const auto own = std::find_if(shot.lights.begin(), shot.lights.end(),
                                  [&](const auto& each) { return each.second == light; });
    exchange::Lamp lamp;
    lamp.name = own != shot.lights.end()
                    ? own->first
                    : fmt::format("placed_light_{}", out.assembly.lamps.size() + 1);
    if (light->as_data(lamp)) out.assembly.lamps.push_back(lamp);
    if (!light->notes().only.empty() || !light->notes().except.empty())
      out.left_out.push_back(fmt::format("which objects the light '{}' is for", lamp.name));
  }
}

}  // namespace

Shot with_meshes(Shot shot) {
  for (ObjectPlan& object : shot.objects) object.direct = false;
  for (PlacePlan& place : shot.places)
    for (Model& model : place.of)
      if (model.scene) model.scene = std::make_shared<const Shot>(with_meshes(*model.scene));
  return shot;
}

exchange::Provenance provenance_of(const Shot& shot) {
  return {shot.recipe, shot.seed, shot.frame, VUG_VERSION};
}

Assembled assemble(Builder& builder) {
  const Shot& shot = builder.shot();
  Assembled out;
  out.assembly.name = shot.name;
  out.assembly.provenance = provenance_of(shot);
  const Cast cast = cast_of(builder);
  Collector collector(out);
  for (const render::Object& object : cast.objects) collector.add(object);
  add_cameras(shot, out);
  add_lamps(shot, cast.lights, out);
  if (shot.medium)
    out.left_out.push_back("the medium in the air: only its volume is written, where it has one");
  return out;
}

}  // namespace vug::session
