// SPDX-License-Identifier: Apache-2.0
// The kinds of rock materials, which are values of parameters of fields.
#pragma once

#include <vug/field/kind.h>
#include <vug/field/material_mix.h>

/// Opens the one definition exported by a file in rock_materials/; see VUG_FIELD_KIND.
#define VUG_ROCK_MATERIAL_KIND(name) VUG_EXPORT_KIND(vug::field, RockMaterialKind, name##_kind)

namespace vug::field {

using RockMaterialKind = Kind<RockMaterialPtr>;
const Kinds<RockMaterialPtr>& rock_materials();

}  // namespace vug::field

namespace vug {

/// A text is a material of that name without hardness.
template <>
struct ValueTraits<field::RockMaterialPtr> : ObjectTraits<field::RockMaterialPtr> {
  static constexpr const char* kWord = "rock material";
  static std::optional<field::RockMaterialPtr> read(const Value& v) {
    if (const std::string* name = v.get<std::string>())
      return std::make_shared<const field::RockMaterial>(field::RockMaterial{*name, 0});
    return ObjectTraits::read(v);
  }
};

}  // namespace vug
