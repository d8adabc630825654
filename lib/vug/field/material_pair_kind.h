// SPDX-License-Identifier: Apache-2.0
// The radius of the blend between two materials, a row of the table of union_by_material.
#pragma once

#include <vug/field/kind.h>

#include <string>
#include <vector>

/// Opens the one definition exported by a file in material_pairs/; see VUG_FIELD_KIND.
#define VUG_MATERIAL_PAIR_KIND(name) VUG_EXPORT_KIND(vug::field, MaterialPairKind, name##_kind)

namespace vug::field {

struct MaterialPair {
  std::vector<std::string> of;  ///< Two names, in any order; they may be equal.
  double radius = 0;            ///< Metres.
};
using MaterialPairKind = Kind<MaterialPair>;
const Kinds<MaterialPair>& material_pairs();

}  // namespace vug::field

namespace vug {

template <>
struct ValueTraits<field::MaterialPair> : ObjectTraits<field::MaterialPair> {
  static constexpr const char* kWord = "material pair";
};

}  // namespace vug
