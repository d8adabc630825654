// SPDX-License-Identifier: Apache-2.0
// The type of instance sources, which the kinds in loading/places/ create, and the transform of a
// pose.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/transform.h>
#include <vug/shot/plan_values.h>

#include <functional>
#include <memory>
#include <vector>

namespace vug::building {

class Builder;

/// One instance of a point instancer.
struct Instance {
  Transform transform;  ///< From the model's space to the scene's.
  RandomKey key{0};     ///< Key of further random choices.
  int model = -1;       ///< Index of the model; -1: random.
};

/// Computes instances when they are needed, since a scatter needs its mesh. `key` is that of the
/// declaration.
using InstanceFunction = std::function<std::vector<Instance>(Builder& builder, RandomKey key)>;

/// An instance function with additional information for validation, obtained by
/// InstanceFunction::target.
struct IndexedInstanceSource {
  InstanceFunction make;
  int last_model = -1;  ///< The largest Instance::model.
  /// Explains why `make` yields no instances; may return an empty string.
  std::function<std::string(Builder& builder, RandomKey key)> empty_reason = nullptr;
  bool is_given = false;  ///< The transforms are given by the scene: `make` builds nothing.

  std::vector<Instance> operator()(Builder& builder, RandomKey key) const {
    return make(builder, key);
  }
};

/// An instance function that depends on the shapes of the models, such as stones at rest; obtained
/// by InstanceFunction::target. Called without models it yields nothing.
struct ModelInstanceSource {
  std::function<std::vector<Instance>(Builder& builder, RandomKey key,
                                      const shot::PointInstancer& plan)>
      make;

  std::vector<Instance> operator()(Builder&, RandomKey) const { return {}; }
};

/// The instances of one source of a declaration, whose key is `key`.
std::vector<Instance> instances_from(const shot::InstanceSource& source, Builder& builder,
                                     RandomKey key, const shot::PointInstancer& plan);

/// Scaling, then rotations about z, x and the vertical y axis, in radians, then the translation.
Transform pose_transform(const Vec3d& position, double yaw, double pitch, double roll,
                         const Vec3d& scale);

}  // namespace vug::building

namespace vug {

/// A vector is converted to a single instance at that position.
template <>
struct ValueTraits<shot::InstanceSource> : ObjectTraits<shot::InstanceSource> {
  static constexpr const char* kWord = "places";
  static std::optional<shot::InstanceSource> read(const Value& v);
};

/// A model: the name of an object, a mesh, or a whole scene.
template <>
struct ValueTraits<shot::Model> {
  static std::string type() { return "model"; }
  static std::optional<shot::Model> read(const Value& v);
  static Value write(const shot::Model& model) { return Object{"model", model}; }
};

}  // namespace vug
