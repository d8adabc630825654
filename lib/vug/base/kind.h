// A kind: a named maker of products that is described by the schema of its parameters. Whatever a
// scene can name is one (a torus, a lamp, a mask); each is one file and one line of a list.
#pragma once

#include <vug/base/schema.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug {

template <class Product>
struct Kind {
  KindInfo info;
  /// The product of the arguments alone; nothing, with diagnostics, where they do not fit.
  std::function<std::optional<Product>(const Arguments&, const SourceLocation&, Diagnostics&)> make;
};
template <class Product>
using Kinds = std::vector<const Kind<Product>*>;

/// A kind whose parameters are the schema's; `build` makes the product of them. An
/// Error(bad_input) that it throws, as for a file that cannot be used, becomes a diagnostic.
template <class Product, class P, class Build>
Kind<Product> make_kind(Schema<P> schema, Build build) {
  KindInfo info = schema.info();
  return {std::move(info),
          [schema = std::move(schema), build = std::move(build)](
              const Arguments& arguments, const SourceLocation& where,
              Diagnostics& diagnostics) -> std::optional<Product> {
            const std::optional<P> params = schema.bind(arguments, where, diagnostics);
            if (!params) return std::nullopt;
            try {
              return build(*params);
            } catch (const Error& error) {
              if (error.code() != ErrorCode::bad_input) throw;
              diagnostics.error(where, error.what(), error.hint());
              return std::nullopt;
            }
          }};
}

/// The same for a struct P with `static void describe(Schema<P>&)`.
template <class Product, class P, class Build>
Kind<Product> make_kind(std::string name, std::string category, Build build) {
  Schema<P> schema(std::move(name), std::move(category));
  P::describe(schema);
  return make_kind<Product>(std::move(schema), std::move(build));
}

/// Finds a kind by name, null when there is none.
template <class Product>
const Kind<Product>* find_kind(const Kinds<Product>& kinds, const std::string& name) {
  for (const auto* kind : kinds)
    if (kind->info.name == name) return kind;
  return nullptr;
}

/// Parameters by name, for callers in C++.
using Named = std::vector<std::pair<std::string, Value>>;

namespace detail {
Arguments as_arguments(const Named& parameters);
[[noreturn]] void refuse_unknown(const std::string& type, const std::string& name,
                                 const std::vector<std::string>& known);
[[noreturn]] void refuse(const Diagnostics& diagnostics);
}  // namespace detail

/// One product of a kind from named parameters; Error(bad_input) when there is no such kind, or
/// with all that does not fit.
template <class Product>
Product make_product(const Kinds<Product>& kinds, const std::string& name,
                     const Named& parameters = {}) {
  const Kind<Product>* kind = find_kind(kinds, name);
  if (!kind) {
    std::vector<std::string> known;
    for (const auto* each : kinds) known.push_back(each->info.name);
    detail::refuse_unknown(ValueTraits<Product>::type(), name, known);
  }
  Diagnostics diagnostics;
  auto product = kind->make(detail::as_arguments(parameters), {}, diagnostics);
  if (!product) detail::refuse(diagnostics);
  return std::move(*product);
}

}  // namespace vug

/// Opens the one definition that a kind's file exports, from outside of any namespace: a function
/// that only the registry of its module declares, so that a new kind compiles two files.
///   VUG_EXPORT_KIND(vug::field, FieldKind, torus_kind) { return ...; }
#define VUG_EXPORT_KIND(module, Type, function)    \
  namespace module {                               \
  static Type make_exported_kind();                \
  const Type& function() {                         \
    static const Type kind = make_exported_kind(); \
    return kind;                                   \
  }                                                \
  }                                                \
  module::Type module::make_exported_kind()
