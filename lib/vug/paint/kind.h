// SPDX-License-Identifier: Apache-2.0
// Registration of masks and paints.
#pragma once

#include <vug/base/kind.h>
#include <vug/field/kind.h>
#include <vug/paint/paint.h>

/// Open the one definition that the file of a mask or a paint exports; see VUG_EXPORT_KIND.
#define VUG_MASK_KIND(name) VUG_EXPORT_KIND(vug::paint, MaskKind, name##_mask)
#define VUG_PAINT_KIND(name) VUG_EXPORT_KIND(vug::paint, PaintKind, name##_paint)

namespace vug::paint {

using MaskKind = Kind<Mask>;
using PaintKind = Kind<Paint>;

const Kinds<Mask>& masks();
const Kinds<Paint>& paints();

/// For kinds whose parameter struct P has `static void describe(Schema<P>&)`; see make_kind.
template <class P, class Build>
MaskKind mask_kind(std::string name, Build build) {
  return make_kind<Mask, P>(std::move(name), "mask", build);
}
/// The same for masks of the attribute that P::name names; calls build(params, uses) with the
/// attribute and its source location.
template <class P, class Build>
MaskKind attribute_mask_kind(std::string name, Build build) {
  Schema<P> schema(std::move(name), "mask");
  P::describe(schema);
  KindInfo info = schema.info();
  const auto make = [schema = std::move(schema), build](
                        const Arguments& arguments, const SourceLocation& where,
                        Diagnostics& diagnostics) -> std::optional<Mask> {
    const std::optional<P> params = schema.bind(arguments, where, diagnostics);
    if (!params) return std::nullopt;
    SourceLocation named = where;
    for (const Argument& each : arguments)
      if (each.name == "name" && each.where.known()) named = each.where;
    return build(*params, AttributeUses{{params->name, named}});
  };
  return {std::move(info), make};
}
template <class P, class Build>
PaintKind paint_kind(std::string name, Build build) {
  return make_kind<Paint, P>(std::move(name), "paint", build);
}

}  // namespace vug::paint

namespace vug {

/// A number is converted to a mask of that value everywhere.
template <>
struct ValueTraits<paint::Mask> : ObjectTraits<paint::Mask> {
  static constexpr const char* kWord = "mask";
  static std::optional<paint::Mask> read(const Value& v) {
    if (const Number* n = v.get<Number>()) {
      const double value = n->value;
      return paint::make_mask([value](const paint::EvalPoint&) { return value; });
    }
    return ObjectTraits::read(v);
  }
};

/// A vector is converted to a paint of that colour.
template <>
struct ValueTraits<paint::Paint> : ObjectTraits<paint::Paint> {
  static constexpr const char* kWord = "paint";
  static std::optional<paint::Paint> read(const Value& v) {
    if (const auto* vector = v.get<Value::Vector>()) {
      const Vec3d color = vector->value;
      return paint::make_paint([color](const paint::EvalPoint&) { return color; });
    }
    return ObjectTraits::read(v);
  }
};

}  // namespace vug
