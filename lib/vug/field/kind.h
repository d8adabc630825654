// SPDX-License-Identifier: Apache-2.0
// Definitions for the source file of a field kind: the schema types and the macro that exports the
// kind.
#pragma once

#include <vug/base/kind.h>
#include <vug/field/field.h>

/// Opens the one definition exported by a kind's file, with the name from its line in
/// CMakeLists.txt:
///   VUG_FIELD_KIND(torus) { return primitive_kind<Torus>("torus"); }
#define VUG_FIELD_KIND(name) VUG_EXPORT_KIND(vug::field, FieldKind, name##_kind)

namespace vug::field {

using FieldKind = Kind<Field>;

/// A kind whose parameter struct P has `static void describe(Schema<P>&)`; see make_kind.
template <class P, class Build>
FieldKind field_kind(std::string name, std::string category, Build build) {
  return make_kind<Field, P>(std::move(name), std::move(category), std::move(build));
}

}  // namespace vug::field

namespace vug {

template <>
struct ValueTraits<field::Field> : ObjectTraits<field::Field> {
  static constexpr const char* kWord = "field";
};

}  // namespace vug
