// SPDX-License-Identifier: Apache-2.0
// Kinds: named factories whose parameters are described by a schema. Everything that a scene can
// name is a kind (a torus, a light, a mask). Each kind is one file and one line of a list.
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
  /// Makes the product from the arguments; empty, with diagnostics, if they are invalid.
  std::function<std::optional<Product>(const Arguments&, const SourceLocation&, Diagnostics&)> make;
};
template <class Product>
using Kinds = std::vector<const Kind<Product>*>;

/// A kind with the parameters of the schema; `build` makes the product from them. An
/// Error(bad_input) thrown by `build`, e.g. for an unusable file, becomes a diagnostic at the call,
/// which names the place in the file.
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
              diagnostics.error(where, error.located_message(), error.hint());
              return std::nullopt;
            }
          }};
}

/// A kind whose parameter struct P has `static void describe(Schema<P>&)`.
template <class Product, class P, class Build>
Kind<Product> make_kind(std::string name, std::string category, Build build) {
  Schema<P> schema(std::move(name), std::move(category));
  P::describe(schema);
  return make_kind<Product>(std::move(schema), std::move(build));
}

/// The kind of that name, or null.
template <class Product>
const Kind<Product>* find_kind(const Kinds<Product>& kinds, const std::string& name) {
  for (const auto* kind : kinds)
    if (kind->info.name == name) return kind;
  return nullptr;
}

/// Arguments by parameter name, for callers in C++.
using NamedValues = std::vector<std::pair<std::string, Value>>;

namespace detail {
Arguments as_arguments(const NamedValues& parameters);
[[noreturn]] void refuse_unknown(const std::string& type, const std::string& name,
                                 const std::vector<std::string>& known);
[[noreturn]] void refuse(const Diagnostics& diagnostics);
}  // namespace detail

/// A product of the kind `name`, made from named arguments. Throws Error(bad_input) if the kind is
/// unknown or arguments are invalid; the message lists all of them.
template <class Product>
Product make_product(const Kinds<Product>& kinds, const std::string& name,
                     const NamedValues& parameters = {}) {
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

/// Opens the only definition that a kind's file exports; used outside of any namespace. Only the
/// registry of the module declares the function, so a new kind compiles two files.
///   VUG_EXPORT_KIND(vug::field, FieldKind, torus_kind) { return ...; }
#define VUG_EXPORT_KIND(module, Type, function) \
  namespace module {                            \
  static Type make_##function();                \
  const Type& function() {                      \
    static const Type kind = make_##function(); \
    return kind;                                \
  }                                             \
  }                                             \
  module::Type module::make_##function()
