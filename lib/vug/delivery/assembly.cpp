// SPDX-License-Identifier: Apache-2.0
#include <vug/building/dice_objects.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/bake.h>
#include <vug/delivery/material_probe.h>
#include <vug/picture/picture_plan.h>
#include <vug/shot/cells_plan.h>
#include <vug/shot/selection.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace vug::delivery {
namespace {

Transform transform_of(const render::Object& object) {
  if (!object.instance) return {};
  const render::Affine at = object.instance->at(0);
  return {Vec3d(at.x), Vec3d(at.y), Vec3d(at.z), Vec3d(at.origin)};
}

/// World-space materials are baked separately for each instance as long as all instances together
/// have no more vertices than this.
constexpr size_t kMaxVertices = 4000000;
/// Number of instances that are baked beyond that limit to find out whether they differ.
constexpr size_t kProbes = 4;

class Collector {
 public:
  explicit Collector(AssemblyResult& out) : out_(out) {}

  void collect(const std::vector<render::Object>& objects) {
    for (const render::Object& object : objects)
      if (varies_by_instance(object)) ++counts_[key_of(object)];
    for (const render::Object& object : objects) add(object);
    make_names_unique();
  }

 private:
  /// Objects with the same mesh and material share a prototype.
  using Key = std::tuple<const void*, const void*, bool, float, float, float>;
  static Key key_of(const render::Object& object) {
    const Vec3f& light = object.emission;
    return {object.mesh.get(), object.material.get(), object.flat, light.x, light.y, light.z};
  }

  void add(const render::Object& object) {
    const size_t part = prototype_of(object);
    exchange::Assembly& all = out_.assembly;
    const auto [known, fresh] =
        groups_.try_emplace({object.name, part, object.instance != nullptr}, all.groups.size());
    if (fresh) all.groups.push_back({object.name, part, {}});
    all.groups[known->second].places.push_back(transform_of(object));
  }

  size_t prototype_of(const render::Object& object) {
    const Key key = key_of(object);
    if (!varies_by_instance(object)) return shared_prototype(key, object);
    const size_t places = counts_.at(key);
    if (places * object.mesh->positions.size() <= kMaxVertices) return own_prototype(key, object);
    if (size_t& probes = probes_[key]; probes < kProbes) {
      ++probes;
      if (!reported_.count(key) && !same(bake(object), bake_without_instance(object))) {
        reported_.insert(key);
        out_.unsupported.push_back(fmt::format(
            "the variation of the look of '{}' over its {} instances, which are too many to "
            "have a mesh each",
            object.name, places));
      }
    }
    return shared_prototype(key, without_instance_look(object));
  }

  size_t shared_prototype(const Key& key, const render::Object& object) {
    const auto [known, fresh] = prototypes_.try_emplace(key, out_.assembly.prototypes.size());
    if (fresh) add_prototype(object, bake(object));
    return known->second;
  }
  /// Instances with equal baked results share a prototype as well.
  size_t own_prototype(const Key& key, const render::Object& object) {
    BakeResult baked = bake(object);
    std::vector<size_t>& made = own_prototypes_[key];
    const Digest digest = mesh::digest(*baked.mesh);
    for (const size_t part : made)
      if (digests_.at(part) == digest && out_.assembly.prototypes[part].look == baked.look)
        return part;
    made.push_back(out_.assembly.prototypes.size());
    digests_[made.back()] = digest;
    add_prototype(object, std::move(baked));
    return made.back();
  }
  void add_prototype(const render::Object& object, BakeResult baked) {
    out_.assembly.prototypes.push_back({object.name,
                                        std::move(baked.mesh),
                                        object.material_name,
                                        baked.look,
                                        {},
                                        std::move(baked.rocks)});
  }

  static render::Object without_instance_look(render::Object object) {
    object.instance = nullptr;
    return object;
  }
  static BakeResult bake_without_instance(const render::Object& object) {
    return bake(without_instance_look(object));
  }
  static bool same(const BakeResult& a, const BakeResult& b) {
    return a.look == b.look && *a.mesh == *b.mesh;
  }

  /// Renames repeated groups, since programs identify objects by name.
  void make_names_unique() {
    std::set<std::string> given;
    for (exchange::InstanceGroup& group : out_.assembly.groups) {
      const std::string own = group.name;
      for (int i = 2; !given.insert(group.name).second; ++i)
        group.name = fmt::format("{}_{}", own, i);
    }
  }

  AssemblyResult& out_;
  std::map<Key, size_t> prototypes_, counts_, probes_;
  std::map<Key, std::vector<size_t>> own_prototypes_;
  std::map<size_t, Digest> digests_;
  std::set<Key> reported_;
  std::map<std::tuple<std::string, size_t, bool>, size_t> groups_;
};

/// The size in pixels of the pictures of a camera.
Vec2i size_of(const shot::Shot& shot, const shot::CameraPlan& camera) {
  const shot::RenderPlan* plan = shot.renders.empty() ? nullptr : &shot.renders.front();
  for (const shot::RenderPlan& each : shot.renders)
    if (each.settings.camera == camera.camera || each.name == camera.name) plan = &each;
  const std::vector<int> size = plan ? plan->settings.size : shot::RenderSettings().size;
  return {size.at(0), size.at(1)};
}

/// The cameras, with that of the first picture first: many programs use the first camera.
std::vector<shot::CameraPlan> in_order(const shot::Shot& shot) {
  std::vector<shot::CameraPlan> cameras = shot.cameras;
  const std::string first = picture::camera_name(shot, picture::plan_picture(shot).render);
  std::stable_partition(cameras.begin(), cameras.end(),
                        [&](const shot::CameraPlan& each) { return each.name == first; });
  return cameras;
}

void add_cameras(const shot::Shot& shot, AssemblyResult& out) {
  const Box3d box = exchange::bounds(out.assembly);
  const double across = box.isEmpty() ? 0 : box.size().length();
  for (const shot::CameraPlan& plan : in_order(shot)) {
    exchange::Camera camera;
    if (!plan.camera->as_data(camera)) {
      out.unsupported.push_back(fmt::format("the camera '{}', which is panoramic", plan.name));
      continue;
    }
    camera.name = plan.name;
    camera.size = size_of(shot, plan);
    camera.aspect = static_cast<double>(camera.size.x) / camera.size.y;
    // The far plane lies behind the whole scene for any camera position in it.
    camera.far = std::max(1000.0, 4 * across);
    out.assembly.cameras.push_back(camera);
  }
}

void add_lights(const shot::Shot& shot, const std::vector<render::LightPtr>& lights,
                AssemblyResult& out) {
  for (const render::LightPtr& light : lights) {
    const auto own = std::find_if(shot.lights.begin(), shot.lights.end(),
                                  [&](const auto& each) { return each.second == light; });
    exchange::Light out_light;
    out_light.name = own != shot.lights.end() ? own->first
                     : light->is_infinite()
                         ? "sky"
                         : fmt::format("placed_light_{}", out.assembly.lights.size() + 1);
    if (light->as_data(out_light)) out.assembly.lights.push_back(out_light);
    if (!light->linking().only.empty() || !light->linking().except.empty())
      out.unsupported.push_back(
          fmt::format("the light linking of '{}': it lights all objects", out_light.name));
  }
}

/// The exported name of a mesh without an object: for cells on a single mesh, the name of that mesh
/// instead of the name of the cells.
std::string shown_name(const shot::Shot& shot, const std::string& name) {
  const auto worn =
      std::find_if(shot.meshes.begin(), shot.meshes.end(), [&](const shot::MeshPtr& mesh) {
        return mesh->name == name && mesh->cells && mesh->parts.empty();
      });
  const bool own = shot.objects.empty() && worn != shot.meshes.end();
  return own ? (*worn)->cells->on.at((*worn)->support)->name : name;
}

}  // namespace

shot::Shot with_meshes(shot::Shot shot) {
  for (shot::ObjectPlan& object : shot.objects) object.direct = false;
  for (shot::PointInstancer& place : shot.instancers)
    for (shot::Model& model : place.of)
      if (model.scene) model.scene = std::make_shared<const shot::Shot>(with_meshes(*model.scene));
  return shot;
}

exchange::Provenance provenance_of(const shot::Shot& shot) {
  return {shot.recipe, shot.seed, shot.frame, VUG_VERSION};
}

AssemblyResult build_assembly(building::Builder& builder) {
  const shot::Shot& shot = builder.shot();
  AssemblyResult out;
  out.assembly.name = shot.name;
  out.assembly.provenance = provenance_of(shot);
  building::FlatScene flat = building::flatten_scene(builder);
  building::dice_objects(builder, shot, {}, flat.objects);
  const shot::MediumPlan* air = shot::find_air(shot, picture::plan_picture(shot).render.settings);
  building::add_default_light(flat, air ? air->medium.get() : nullptr);
  for (render::Object& object : flat.objects) object.name = shown_name(shot, object.name);
  Collector(out).collect(flat.objects);
  add_cameras(shot, out);
  add_lights(shot, flat.lights, out);
  return out;
}

}  // namespace vug::delivery
