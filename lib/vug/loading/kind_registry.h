// SPDX-License-Identifier: Apache-2.0
// The registries of all kinds that a scene can call, with type-erased products, for the resolver
// and `vug list`.
#pragma once

#include <vug/base/kind.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vug::loading {

/// A kind with a type-erased product.
struct RegisteredKind {
  const KindInfo* info = nullptr;
  std::function<std::optional<Value>(const Arguments&, const SourceLocation&, Diagnostics&)> make;
};

/// Erases the product type of a kind, which must outlive the result.
template <class Product>
RegisteredKind registered_kind(const Kind<Product>& kind) {
  return {&kind.info,
          [&kind](const Arguments& arguments, const SourceLocation& where,
                  Diagnostics& diagnostics) -> std::optional<Value> {
            auto product = kind.make(arguments, where, diagnostics);
            if (!product) return std::nullopt;
            return ValueTraits<Product>::write(*product);
          }};
}

/// All kinds whose product has one type.
struct KindRegistry {
  std::string type;  ///< "field", "light", ...
  std::vector<RegisteredKind> kinds;

  const RegisteredKind* find(const std::string& name) const;
};

/// Whether `word` is one of the choices of the kind's parameter.
bool has_choice(const KindInfo& kind, const std::string& parameter, const std::string& word);

/// All registries, with the kinds of plugins that were loaded before the first call.
const std::vector<KindRegistry>& kind_registries();
/// The registry of a product type; null if there is none.
const KindRegistry* find_registry(const std::string& type);

}  // namespace vug::loading
