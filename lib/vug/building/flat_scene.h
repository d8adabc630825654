// What a shot shows: its objects, and what it places, with all that stands in placed scenes.
#pragma once

#include <vug/building/builder.h>

#include <vector>

namespace vug::building {

/// Objects, instances and lamps; those of placed scenes have names "PLACE/OBJECT" there.
struct FlatScene {
  std::vector<render::Object> objects;
  std::vector<render::LightPtr> lights;
};

/// A shot at several times.
using TimeSamples = std::vector<std::shared_ptr<const shot::Shot>>;

/// `moments`: at times evenly spread while the shutter is open, with the same objects for what
/// stands still (see Still): what is placed goes through its places there. None: it stays where it
/// is at its frame, as it does where its places become more or fewer; so do lamps. Builds all
/// meshes. Error(bad_input), with the place's name in the text, for places that cannot
/// be rendered.
FlatScene flatten_scene(Builder& builder, const TimeSamples& time_samples = {});

/// A soft sky for a shot in which nothing shines: no light, no object, and not the `medium`, which
/// may be null.
void add_default_light(FlatScene& flat, const render::Medium* medium);

}  // namespace vug::building
