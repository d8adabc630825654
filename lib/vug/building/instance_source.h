// Where a scene puts things that it has several of: one place, a list, a file, a scatter.
#pragma once

#include <vug/base/rng.h>
#include <vug/base/transform.h>
#include <vug/shot/plan_values.h>

#include <functional>
#include <memory>
#include <vector>

namespace vug::building {

class Builder;

struct Instance {
  Transform transform;  ///< From the thing's own space to the scene's.
  RandomKey key{0};     ///< Of what chance still decides.
  int model = -1;       ///< Which of the things stands there; -1: chance decides.
};

/// Found when the picture needs them: a scatter needs its mesh. `key` is that of the declaration.
using InstanceFunction = std::function<std::vector<Instance>(Builder& builder, RandomKey key)>;

/// A maker of which more is known, so that the text can be judged by it: InstanceFunction::target
/// finds it.
struct IndexedInstanceSource {
  InstanceFunction make;
  int last_model = -1;  ///< The highest Place::model.
  /// A sentence on why there are no places where `make` makes none; may be empty.
  std::function<std::string(Builder& builder, RandomKey key)> empty_reason = nullptr;

  std::vector<Instance> operator()(Builder& builder, RandomKey key) const {
    return make(builder, key);
  }
};

/// Turned about z, then x, then the upright y, then moved; radians.
Transform pose_transform(const Vec3d& position, double yaw, double pitch, double roll,
                         const Vec3d& scale);

}  // namespace vug::building

namespace vug {

/// A vector stands for that one place.
template <>
struct ValueTraits<shot::InstanceSource> : ObjectTraits<shot::InstanceSource> {
  static constexpr const char* kWord = "places";
  static std::optional<shot::InstanceSource> read(const Value& v);
};

/// What can be placed: the name of an object, a mesh, or a whole scene.
template <>
struct ValueTraits<shot::Model> {
  static std::string type() { return "model"; }
  static std::optional<shot::Model> read(const Value& v);
  static Value write(const shot::Model& model) { return Object{"model", model}; }
};

}  // namespace vug
