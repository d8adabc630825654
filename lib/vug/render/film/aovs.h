// Which layers a picture has, and how they come out of a film's sums.
#pragma once

#include <vug/image/image.h>
#include <vug/render/film/film.h>
#include <vug/render/film/light_path_recorder.h>

#include <string>
#include <vector>

namespace vug::render {

struct Scene;

/// The layer of MotionStep::motion, in pixels.
inline constexpr const char* kMotion = "motion";

/// A layer that any scene has.
struct AovInfo {
  std::string name;
  std::string doc;
  std::vector<std::string> channels;
  bool is_default = false;  ///< Written when nothing else is asked for.
};
const std::vector<AovInfo>& aovs();

inline constexpr const char* kWetness = "wetness";

/// An attribute of meshes that has a layer.
struct AovAttribute {
  std::string name;
  uint32_t arity = 1;  ///< Numbers at each vertex; three are read at most.

  bool operator==(const AovAttribute&) const = default;
};

/// The layers of one picture, in the order of `aovs()`, then lights by their groups, then
/// attributes of meshes.
struct AovPlan {
  std::vector<std::string> names;   ///< Of aovs(), "light_GROUP" and "attribute_NAME".
  std::vector<std::string> groups;  ///< Groups of lights that have a layer.
  /// Those that have a layer, then those of numbers 0 and 1 that CryptoElement is made of.
  std::vector<AovAttribute> attributes;
  /// Of the scene's objects, by their index, for the layers of the Cryptomatte.
  std::vector<std::string> objects, materials;

  /// Names of the channels of the picture.
  std::vector<std::string> channels() const;
  /// What a film must layout for it.
  FilmLayout layout() const;
  bool has(const std::string& name) const;
  bool has_components() const;   ///< Any of the parts of the beauty.
  size_t first_element() const;  ///< In `attributes`.
  /// The names that a layer of the Cryptomatte tells apart, by what it finds them by: the index of
  /// the object, or that among the elements.
  std::vector<std::string> subjects(const std::string& layer) const;

  bool operator==(const AovPlan&) const = default;
};

/// The plan for names as people give them: those of aovs(), "light_GROUP", "parts" (all of the
/// beauty's), "lights" (all groups), "attribute_NAME", "attributes" (all),
/// "cryptomatte" (all of its) or "all"; none: the is_default ones. Only where there are elements is
/// there a "CryptoElement". Error(bad_input) with the nearest name for any other, or when R, G, B
/// would be missing.
AovPlan plan_aovs(const std::vector<std::string>& names, const std::vector<std::string>& groups,
                  const std::vector<AovAttribute>& attributes = {},
                  const std::vector<std::string>& elements = {});

/// The same with the groups of lights, attributes, elements, objects and materials of the scene.
/// Where objects have no meshes yet any attribute is taken to be there.
AovPlan scene_aovs(const Scene& scene, const std::vector<std::string>& names);

/// Writes the means of a film into the image, whose pixel (0, 0) is `origin` of the film and whose
/// channels are the plan's.
void develop(const Film& film, const AovPlan& plan, const Region& origin, image::Image& image);

}  // namespace vug::render
