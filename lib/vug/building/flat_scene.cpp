// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/flat_scene.h>
#include <vug/building/make_mesh.h>
#include <vug/building/merge_copies.h>
#include <vug/render/geometry/require_static.h>
#include <vug/render/kinds.h>
#include <vug/render/lighting/transformed_light.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::building {
namespace {

/// Memory of one instance in bytes, in the renderer and here.
constexpr double kInstanceBytes = 2000;
/// With more instances than this, the copies inside a model are merged; see merge_copies.
constexpr size_t kManyInstances = 50000;

/// The name of an object's material in mattes; `otherwise` if the material has no name.
std::string material_name(const shot::Shot& shot, const render::MaterialPtr& of,
                          const std::string& otherwise) {
  if (!of) return "default";
  for (const auto& [name, material] : shot.materials)
    if (material == of) return name;
  return otherwise;
}

render::Object make_object(Builder& builder, const shot::ObjectPlan& plan) {
  render::Object object{plan.name,
                        plan.direct ? nullptr : builder.mesh(plan.mesh),
                        plan.material,
                        plan.flat,
                        Vec3f(plan.emission),
                        plan.light_group,
                        material_name(builder.shot(), plan.material, plan.name),
                        builder.solid(plan.mesh)};
  if (!plan.direct) object.elements = shot::element_names(*plan.mesh);
  if (plan.direct) {
    object.surface = builder.surface(plan.mesh);
    object.color = plan.mesh->paint;
  }
  return object;
}

FlatScene flatten_scene(Builder& builder, const shot::Model& model) {
  if (model.scene) {
    BuildOptions options = builder.options();
    options.max_memory = builder.memory_budget();
    Builder other(*model.scene, options, builder.progress());
    return flatten_scene(other);
  }
  FlatScene scene;
  if (const auto object = shot::object_of(builder.shot(), model))
    scene.objects.push_back(make_object(builder, *object));
  return scene;
}

Transform transform_of(const render::Affine& a) {
  return {Vec3d(a.x), Vec3d(a.y), Vec3d(a.z), Vec3d(a.origin)};
}

/// One transform, or one for each time sample.
using TransformSamples = std::vector<Transform>;

render::InstanceTransformPtr instance_transform(TransformSamples sample,
                                                const render::InstanceTransformPtr& own) {
  if (own)
    for (Transform& instance : sample) instance = instance * transform_of(own->at(0));
  return std::make_shared<const render::InstanceTransform>(sample);
}

struct InstanceNames {
  std::string object;    ///< The name of its only object, or the prefix of their names.
  std::string material;  ///< The name of the material of the instancer.
};

/// Adds an instance of all objects and lights of a model.
void add_instance(const FlatScene& model, const Instance& instance, const TransformSamples& sample,
                  const shot::PointInstancer& plan, const InstanceNames& names, FlatScene& scene) {
  const bool single = model.objects.size() == 1;
  const auto renamed = [&](const std::string& own) {
    return single ? names.object : names.object + "/" + own;
  };
  for (const render::Object& object : model.objects) {
    render::Object here = object;
    here.name = renamed(object.name);
    here.instance = instance_transform(sample, object.instance);
    if (plan.material) {
      here.material = plan.material;
      here.material_name = names.material;
      here.world_space_material = true;
    }
    render::require_static(here);
    scene.objects.push_back(std::move(here));
  }
  for (const render::LightPtr& light : model.lights) {
    if (light->is_infinite()) continue;
    render::LightLinking linking = light->linking();
    for (std::vector<std::string>* linked : {&linking.only, &linking.except})
      std::transform(linked->begin(), linked->end(), linked->begin(), renamed);
    scene.lights.push_back(
        render::transformed_light(light, instance.transform, std::move(linking)));
  }
}

std::vector<Instance> instances_of(Builder& builder, const shot::PointInstancer& plan) {
  std::vector<Instance> instances;
  for (size_t i = 0; i < plan.at.size(); ++i) try {
      const std::vector<Instance> more = instances_from(plan.at[i], builder, plan.key.at(i), plan);
      instances.insert(instances.end(), more.begin(), more.end());
    } catch (const Error& error) {
      if (error.where().known()) throw;
      throw error.at(plan.where);
    }
  return instances;
}

std::string empty_reason(Builder& builder, const shot::PointInstancer& plan) {
  for (size_t i = 0; i < plan.at.size(); ++i)
    if (const auto* known = plan.at[i]->target<IndexedInstanceSource>();
        known && known->empty_reason)
      if (std::string why = known->empty_reason(builder, plan.key.at(i)); !why.empty()) return why;
  return "all its instances are masked out, or their source is empty";
}

bool same(const Transform& a, const Transform& b) {
  return a.origin() == b.origin() && a.column(0) == b.column(0) && a.column(1) == b.column(1) &&
         a.column(2) == b.column(2);
}

/// The transforms of each instance at the time samples; a single transform for each static
/// instance, even if other instances of the declaration move.
std::vector<TransformSamples> transform_samples(Builder& builder, const shot::PointInstancer& plan,
                                                const std::vector<Instance>& instances,
                                                const TimeSamples& time_samples) {
  std::vector<TransformSamples> still, samples(instances.size());
  for (const Instance& instance : instances) still.push_back({instance.transform});
  for (const auto& sample_shot : time_samples) {
    const auto other =
        std::find_if(sample_shot->instancers.begin(), sample_shot->instancers.end(),
                     [&](const shot::PointInstancer& each) { return each.name == plan.name; });
    if (other == sample_shot->instancers.end()) return still;
    const std::vector<Instance> there =
        other->at == plan.at ? instances : instances_of(builder, *other);
    if (there.size() != instances.size()) return still;
    for (size_t i = 0; i < samples.size(); ++i) samples[i].push_back(there[i].transform);
  }
  if (time_samples.empty()) return still;
  for (TransformSamples& sample : samples)
    if (std::all_of(sample.begin(), sample.end(),
                    [&](const auto& each) { return same(each, sample[0]); }))
      sample.resize(1);
  return samples;
}

void add_instances(Builder& builder, const shot::PointInstancer& plan,
                   const TimeSamples& time_samples, FlatScene& scene) {
  std::vector<FlatScene> models;
  for (const shot::Model& model : plan.of) models.push_back(flatten_scene(builder, model));
  const std::string material = material_name(builder.shot(), plan.material, plan.name);
  const std::vector<Instance> instances = instances_of(builder, plan);
  if (instances.empty())
    builder.warn(plan.where, fmt::format("'{}' has no instances", plan.name),
                 empty_reason(builder, plan));
  const auto object_count = [&] {
    size_t count = 0;
    for (const Instance& instance : instances)
      count += models[static_cast<size_t>(choose_model(instance, plan))].objects.size();
    return count;
  };
  if (instances.size() > 1 && object_count() > kManyInstances)
    for (FlatScene& model : models) model.objects = merge_copies(model.objects);
  require_memory(kInstanceBytes * static_cast<double>(object_count()), builder.memory_budget(),
                 fmt::format("{} instances", object_count()), "use fewer instances");
  const std::vector<TransformSamples> samples =
      transform_samples(builder, plan, instances, time_samples);
  for (size_t i = 0; i < instances.size(); ++i)
    add_instance(
        models[static_cast<size_t>(choose_model(instances[i], plan))], instances[i], samples[i],
        plan, {plan.apart ? fmt::format("{}/{}", plan.name, i + 1) : plan.name, material}, scene);
}

}  // namespace

int choose_model(const Instance& instance, const shot::PointInstancer& plan) {
  const auto count = static_cast<int>(plan.of.size());
  if (instance.model >= count)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("an instance uses model number {}, but the last model of '{}' is number {}",
                    instance.model, plan.name, count - 1));
  if (instance.model >= 0 || count == 1) return std::max(instance.model, 0);
  double total = 0;
  for (int i = 0; i < count; ++i)
    total += plan.shares.empty() ? 1 : plan.shares[static_cast<size_t>(i)];
  double at = RandomStream(instance.key.at("model")).uniform() * total;
  for (int i = 0; i < count - 1; ++i) {
    at -= plan.shares.empty() ? 1 : plan.shares[static_cast<size_t>(i)];
    if (at < 0) return i;
  }
  return count - 1;
}

void add_default_light(FlatScene& scene, const render::Medium* medium) {
  const auto shines = [](const render::Object& object) {
    return !render::is_black(object.emission) ||
           (object.material && object.material->is_emissive());
  };
  if (!scene.lights.empty() || (medium && medium->is_emissive()) ||
      std::any_of(scene.objects.begin(), scene.objects.end(), shines))
    return;
  scene.lights.push_back(render::make_light("sky", {{"radiance", Vec3d(0.9, 0.95, 1)}}));
}

FlatScene flatten_scene(Builder& builder, const TimeSamples& time_samples) {
  return flatten_scene(builder, builder.shot(), time_samples);
}

FlatScene flatten_scene(Builder& builder, const shot::Shot& part, const TimeSamples& time_samples) {
  const std::vector<shot::ObjectPlan> shown = shot::shown_objects(part);
  for (const shot::ObjectPlan& object : shown)
    object.direct ? builder.require_surface_memory(object.mesh)
                  : builder.require_mesh_memory(object.mesh);
  FlatScene scene;
  for (const shot::ObjectPlan& object : shown)
    scene.objects.push_back(make_object(builder, object));
  for (const auto& [name, light] : part.lights) scene.lights.push_back(light);
  for (const shot::PointInstancer& plan : part.instancers) {
    try {
      add_instances(builder, plan, time_samples, scene);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input || error.where().line > 0) throw;
      throw error.at(plan.where);
    }
  }
  return scene;
}

}  // namespace vug::building
