// SPDX-License-Identifier: Apache-2.0
// The AOVs of a picture, and their computation from a film's sums.
#pragma once

#include <vug/image/image.h>
#include <vug/render/film/film.h>
#include <vug/render/film/light_path_recorder.h>

#include <string>
#include <vector>

namespace vug::render {

struct Scene;

/// Name of the AOV of MotionStep::motion, in pixels.
inline constexpr const char* kMotion = "motion";

/// An AOV that is available in every scene.
struct AovInfo {
  std::string name;
  std::string doc;
  std::vector<std::string> channels;
  bool is_default = false;  ///< Written if no AOVs are requested.
};
const std::vector<AovInfo>& aovs();

/// A mesh attribute that has an AOV.
struct AovAttribute {
  std::string name;
  uint32_t arity = 1;  ///< Values per vertex; at most three are read.

  bool operator==(const AovAttribute&) const = default;
};

/// The AOVs of one picture, in the order of `aovs()`, followed by light groups and mesh attributes.
struct AovPlan {
  std::vector<std::string> names;   ///< Names from aovs(), "light_GROUP" and "attribute_NAME".
  std::vector<std::string> groups;  ///< Light groups that have an AOV.
  /// Attributes that have an AOV, then the attributes with values 0 and 1 that form CryptoElement.
  std::vector<AovAttribute> attributes;
  /// Names of the scene's objects and of their materials, by object index, for Cryptomatte.
  std::vector<std::string> objects, materials;

  /// Channel names of the picture.
  std::vector<std::string> channels() const;
  /// The data that a film must accumulate for these AOVs and, if requested, a deep picture.
  FilmLayout layout(bool deep = false) const;
  bool has(const std::string& name) const;
  bool has_components() const;   ///< True with any light component of the beauty.
  size_t first_element() const;  ///< Index in `attributes`.
  /// Names in the manifest of a Cryptomatte AOV, in the order of its ids: by object index, or by
  /// index among the elements.
  std::vector<std::string> crypto_names(const std::string& layer) const;

  bool operator==(const AovPlan&) const = default;
};

/// Creates the plan for requested names: those of aovs(), "light_GROUP", "parts" (all light
/// components of the beauty), "lights" (all groups), "attribute_NAME", "attributes" (all),
/// "cryptomatte" (all Cryptomatte AOVs) or "all"; without names, the default AOVs. "CryptoElement"
/// exists only if there are elements. Throws Error(bad_input) for other names, with the most
/// similar name, and if R, G, B would be missing.
AovPlan plan_aovs(const std::vector<std::string>& names, const std::vector<std::string>& groups,
                  const std::vector<AovAttribute>& attributes = {},
                  const std::vector<std::string>& elements = {});

/// Creates the plan with the light groups, attributes, elements, objects and materials of the
/// scene. If objects have no meshes yet, every requested attribute is assumed to exist.
AovPlan scene_aovs(const Scene& scene, const std::vector<std::string>& names);

/// Writes the means of a film into the image. Pixel (0, 0) of the image is the top left corner of
/// `origin`; its channels are those of the plan.
void develop(const Film& film, const AovPlan& plan, const Region& origin, image::Image& image);

}  // namespace vug::render
