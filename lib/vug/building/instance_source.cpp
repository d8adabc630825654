// SPDX-License-Identifier: Apache-2.0
#include <vug/building/instance_source.h>

namespace vug::building {

std::vector<Instance> instances_from(const shot::InstanceSource& source, Builder& builder,
                                     RandomKey key, const shot::PointInstancer& plan) {
  const auto* with_models = source->target<ModelInstanceSource>();
  return with_models ? with_models->make(builder, key, plan) : (*source)(builder, key);
}

Transform pose_transform(const Vec3d& position, double yaw, double pitch, double roll,
                         const Vec3d& scale) {
  return Transform::translation(position) * Transform::rotation({0, 1, 0}, yaw) *
         Transform::rotation({1, 0, 0}, pitch) * Transform::rotation({0, 0, 1}, roll) *
         Transform::scaling(scale);
}

}  // namespace vug::building

namespace vug {

std::optional<shot::InstanceSource> ValueTraits<shot::InstanceSource>::read(const Value& v) {
  const auto* vector = v.get<Value::Vector>();
  if (!vector) return ObjectTraits::read(v);
  const Vec3d position = vector->value;
  const auto make = [position](building::Builder&,
                               RandomKey key) -> std::vector<building::Instance> {
    return {{Transform::translation(position), key, -1}};
  };
  return std::make_shared<const building::InstanceFunction>(
      building::IndexedInstanceSource{.make = make, .is_given = true});
}

std::optional<shot::Model> ValueTraits<shot::Model>::read(const Value& v) {
  shot::Model model;
  if (const auto* name = v.get<Value::Name>()) {
    model.name = name->text;
    return model;
  }
  if (const auto* mesh = v.object<shot::MeshPtr>()) {
    model.name = (*mesh)->name;
    model.mesh = *mesh;
    return model;
  }
  const auto* given = v.object<shot::Model>();
  return given ? std::optional(*given) : std::nullopt;
}

}  // namespace vug
