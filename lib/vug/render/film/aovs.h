// Which layers a picture has, and how they come out of a film's sums.
#pragma once

#include <vug/image/image.h>
#include <vug/render/film/film.h>
#include <vug/render/film/light_path_recorder.h>

#include <string>
#include <vector>

namespace vug::render {

struct Scene;

/// The layer of FrameStep::motion, in pixels.
inline constexpr const char* kMotion = "motion";

/// A layer that any scene has.
struct LayerInfo {
  std::string name;
  std::string doc;
  std::vector<std::string> channels;
  bool usual = false;  ///< Written when nothing else is asked for.
};
const std::vector<LayerInfo>& layers();

inline constexpr const char* kWetness = "wetness";

/// An attribute of meshes that has a layer.
struct LayerAttribute {
  std::string name;
  uint32_t arity = 1;  ///< Numbers at each vertex; three are read at most.

  bool operator==(const LayerAttribute&) const = default;
};

/// The layers of one picture, in the order of `layers()`, then lights by their groups, then
/// attributes of meshes.
struct LayerPlan {
  std::vector<std::string> names;   ///< Of layers(), "light_GROUP" and "attribute_NAME".
  std::vector<std::string> groups;  ///< Groups of lights that have a layer.
  /// Those that have a layer, then those of numbers 0 and 1 that CryptoElement is made of.
  std::vector<LayerAttribute> attributes;
  /// Of the scene's objects, by their index, for the layers of the Cryptomatte.
  std::vector<std::string> objects, materials;

  /// Names of the channels of the picture.
  std::vector<std::string> channels() const;
  /// What a film must gather for it.
  Gather gather() const;
  bool has(const std::string& name) const;
  bool parts() const;            ///< Any of the parts of the beauty.
  size_t first_element() const;  ///< In `attributes`.
  /// The names that a layer of the Cryptomatte tells apart, by what it finds them by: the index of
  /// the object, or that among the elements.
  std::vector<std::string> subjects(const std::string& layer) const;

  bool operator==(const LayerPlan&) const = default;
};

/// The plan for names as people give them: those of layers(), "light_GROUP", "parts" (all of the
/// beauty's), "lights" (all groups), "attribute_NAME", "attributes" (all),
/// "cryptomatte" (all of its) or "all"; none: the usual ones. Only where there are elements is
/// there a "CryptoElement". Error(bad_input) with the nearest name for any other, or when R, G, B
/// would be missing.
LayerPlan plan_layers(const std::vector<std::string>& names, const std::vector<std::string>& groups,
                      const std::vector<LayerAttribute>& attributes = {},
                      const std::vector<std::string>& elements = {});

/// The same with the groups of lights, attributes, elements, objects and materials of the scene.
/// Where objects have no meshes yet any attribute is taken to be there.
LayerPlan scene_layers(const Scene& scene, const std::vector<std::string>& names);

/// Writes the means of a film into the image, whose pixel (0, 0) is `origin` of the film and whose
/// channels are the plan's.
void develop(const Film& film, const LayerPlan& plan, const Region& origin, image::Image& image);

}  // namespace vug::render
