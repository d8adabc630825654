// SPDX-License-Identifier: Apache-2.0
// The AOVs of a picture, and their computation from a film's sums.
#pragma once

#include <vug/image/image.h>
#include <vug/render/film/aov_table.h>
#include <vug/render/film/film.h>

#include <string>
#include <vector>

namespace vug::render {

struct Scene;

/// A mesh attribute that has an AOV.
struct AovAttribute {
  std::string name;
  uint32_t arity = 1;  ///< Values per vertex; at most three are read.

  bool operator==(const AovAttribute&) const = default;
};

/// The AOVs of one picture.
struct AovPlan {
  std::vector<std::string> names;   ///< In the order of the table; see `aovs`.
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
  size_t count(AovSource source) const;
  /// False if the lists do not belong to each other, as in a damaged file.
  bool is_consistent() const;
  bool has_components() const;   ///< True with any light component of the beauty.
  size_t first_element() const;  ///< Index in `attributes`.
  /// Names in the manifest of a Cryptomatte AOV, in the order of its ids: by object index, or by
  /// index among the elements.
  std::vector<std::string> crypto_names(const std::string& layer) const;

  bool operator==(const AovPlan&) const = default;
};

/// Creates the plan for requested names: those of the table, with the names of light groups and
/// attributes, names of sets (AovInfo::set), or "all"; without names, the default AOVs.
/// "CryptoElement" exists only if there are elements. Throws Error(bad_input) for other names, with
/// the most similar name, and if R, G, B would be missing.
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
