// What a file of a mask or a paint needs.
#pragma once

#include <vug/base/schema.h>
#include <vug/field/kind.h>
#include <vug/paint/paint.h>

namespace vug::paint {

using MaskKind = Kind<Mask>;
using PaintKind = Kind<Paint>;

#define VUG_KIND(name) const MaskKind& name##_mask();
#include <vug/paint/masks_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const PaintKind& name##_paint();
#include <vug/paint/paints_kinds.inc>
#undef VUG_KIND

const std::vector<const MaskKind*>& masks();
const std::vector<const PaintKind*>& paints();

/// A kind whose parameter struct P has `describe(Schema<P>&)`; `build` makes the product.
template <class Product, class P, class Build>
Kind<Product> surface_kind(std::string name, std::string category, Build build) {
  Schema<P> schema;
  schema.info().name = std::move(name);
  schema.info().category = std::move(category);
  P::describe(schema);
  return {schema.info(),
          [schema, build](const Arguments& arguments, SourceLocation where,
                          Diagnostics& diagnostics) -> std::optional<Product> {
            Diagnostics own;
            const P params = schema.bind(arguments, std::move(where), own);
            diagnostics.append(own);
            if (own.has_errors()) return std::nullopt;
            return build(params);
          }};
}
template <class P, class Build>
MaskKind mask_kind(std::string name, Build build) {
  return surface_kind<Mask, P>(std::move(name), "mask", build);
}
template <class P, class Build>
PaintKind paint_kind(std::string name, Build build) {
  return surface_kind<Paint, P>(std::move(name), "paint", build);
}

}  // namespace vug::paint

namespace vug {

/// A number stands for the mask that is that number everywhere.
template <>
struct ValueTraits<paint::Mask> {
  static std::string type() { return "mask"; }
  static std::optional<paint::Mask> read(const Value& v) {
    if (const Number* n = v.get<Number>()) {
      const double value = n->value;
      return paint::make_mask([value](const paint::Spot&) { return value; });
    }
    const auto* mask = v.object<paint::Mask>();
    return mask ? std::optional(*mask) : std::nullopt;
  }
  static Value write(const paint::Mask& mask) {
    return mask ? Value(Object{"mask", mask}) : Value();
  }
};

/// A vector stands for the paint of that colour.
template <>
struct ValueTraits<paint::Paint> {
  static std::string type() { return "paint"; }
  static std::optional<paint::Paint> read(const Value& v) {
    if (const auto* vector = v.get<Value::Vector>()) {
      const Vec3d color = vector->value;
      return paint::make_paint([color](const paint::Spot&) { return color; });
    }
    const auto* made = v.object<paint::Paint>();
    return made ? std::optional(*made) : std::nullopt;
  }
  static Value write(const paint::Paint& made) {
    return made ? Value(Object{"paint", made}) : Value();
  }
};

}  // namespace vug
