// SPDX-License-Identifier: Apache-2.0
// Labels of parts of a surface, such as the passages of a cave, for Cryptomatte and masks.
#pragma once

#include <vug/field/kind.h>

#include <string>
#include <vector>

namespace vug::shot {

/// A name for the part of a surface that is nearest to a solid.
struct SurfaceLabel {
  std::string name;
  field::Field field;

  bool operator==(const SurfaceLabel& other) const {
    return name == other.name && field.node() == other.field.node();
  }
};

/// The names of the labels, each once, in their order.
std::vector<std::string> label_names(const std::vector<SurfaceLabel>& labels);

/// The kinds listed in CMakeLists.txt.
const Kinds<SurfaceLabel>& label_kinds();
using LabelKind = Kind<SurfaceLabel>;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_LABEL_KIND(name) VUG_EXPORT_KIND(vug::shot, LabelKind, name##_surface_label)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::SurfaceLabel> : ObjectTraits<shot::SurfaceLabel> {
  static constexpr const char* kWord = "label";
};

}  // namespace vug
