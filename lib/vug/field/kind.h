// What a file of a field kind needs: the schema types and the macro that names its maker.
#pragma once

#include <vug/base/schema.h>
#include <vug/field/field.h>

/// Opens the one definition a kind's file exports, under the name of its line in CMakeLists.txt:
///   VUG_FIELD_KIND(torus) { return primitive_kind<Torus>("torus"); }
#define VUG_FIELD_KIND(name)                               \
  static vug::field::FieldKind make_##name##_kind();       \
  const vug::field::FieldKind& vug::field::name##_kind() { \
    static const FieldKind kind = make_##name##_kind();    \
    return kind;                                           \
  }                                                        \
  static vug::field::FieldKind make_##name##_kind()

namespace vug::field {

using FieldKind = Kind<Field>;

#define VUG_KIND(name) const FieldKind& name##_kind();
#include <vug/field/deformers_kinds.inc>
#include <vug/field/detail_kinds.inc>
#include <vug/field/operators_kinds.inc>
#include <vug/field/primitives_kinds.inc>
#undef VUG_KIND

/// A kind whose parameter struct P has `describe(Schema<P>&)` and `std::string fault() const`
/// (empty, or a sentence on parameters that do not fit together); `build` makes the product, and
/// an Error it throws becomes a diagnostic at the kind's place.
template <class Product, class P, class Build>
Kind<Product> product_kind(std::string name, std::string category, Build build) {
  Schema<P> schema;
  schema.info().name = std::move(name);
  schema.info().category = std::move(category);
  P::describe(schema);
  KindInfo info = schema.info();
  return {std::move(info),
          [schema = std::move(schema), build](const Arguments& arguments, SourceLocation where,
                                              Diagnostics& diagnostics) -> std::optional<Product> {
            Diagnostics own;
            const P params = schema.bind(arguments, where, own);
            if (!own.has_errors()) {
              std::string fault;
              if constexpr (requires { params.fault(); }) fault = params.fault();
              try {
                if (fault.empty()) return build(params);
                own.error(where, fault);
              } catch (const Error& e) {  // a file that cannot be used is the argument's fault
                if (e.code() != ErrorCode::bad_input) throw;
                own.error(where, e.what(), e.hint());
              }
            }
            diagnostics.append(own);
            return std::nullopt;
          }};
}

template <class P, class Build>
FieldKind field_kind(std::string name, std::string category, Build build) {
  return product_kind<Field, P>(std::move(name), std::move(category), std::move(build));
}

}  // namespace vug::field

namespace vug {

template <>
struct ValueTraits<field::Field> {
  static std::string type() { return "field"; }
  static std::optional<field::Field> read(const Value& v) {
    const auto* f = v.object<field::Field>();
    return f ? std::optional(*f) : std::nullopt;
  }
  static Value write(const field::Field& f) { return Object{"field", f}; }
};

}  // namespace vug
