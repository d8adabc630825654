// SPDX-License-Identifier: Apache-2.0
// Flattens a shot into a list of objects and lights, with the contents of placed scenes as
// instances and their transforms while the shutter is open, and adds the light of scenes without
// lights.
#pragma once

#include <vug/building/builder.h>
#include <vug/building/instance_source.h>

#include <vector>

namespace vug::building {

/// Objects, instances and lights; those of placed scenes are named "PLACE/OBJECT".
struct FlatScene {
  std::vector<render::Object> objects;
  std::vector<render::LightPtr> lights;
};

/// A shot at several times while the shutter is open.
using TimeSamples = std::vector<std::shared_ptr<const shot::Shot>>;

/// Instances are motion-blurred across `time_samples`, which are evenly spaced and share static
/// plans (see loading::StaticCache). Without time samples, or if the instance count changes between
/// them, instances use the pose at the frame. Lights are never blurred. Builds all meshes.
/// Error(bad_input), located at the name of the `place`, for instances that cannot be rendered.
FlatScene flatten_scene(Builder& builder, const TimeSamples& time_samples = {});
/// The same for a part of the builder's shot; see shot/selection.h.
FlatScene flatten_scene(Builder& builder, const shot::Shot& part, const TimeSamples& time_samples);

/// The index of the model of an instance: its own, or a random one. Error(bad_input) if the
/// instance has a model that the plan lacks.
int choose_model(const Instance& instance, const shot::PointInstancer& plan);

/// Adds a uniform sky if the scene has no light, no emissive object and no emissive `medium`, which
/// may be null.
void add_default_light(FlatScene& flat, const render::Medium* medium);

}  // namespace vug::building
