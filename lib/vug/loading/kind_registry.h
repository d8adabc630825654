// The families of kinds a scene can call, with their product types erased: what the resolver and
// `vug list` loop over.
#pragma once

#include <vug/base/kind.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vug::loading {

struct RegisteredKind {
  const KindInfo* info = nullptr;
  std::function<std::optional<Value>(const Arguments&, const SourceLocation&, Diagnostics&)> make;
};

/// The kind, of whatever product; it must outlive what is given.
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

/// All kinds whose product is of one type.
struct KindRegistry {
  std::string type;  ///< "field", "light", ...
  std::vector<RegisteredKind> kinds;

  const RegisteredKind* find(const std::string& name) const;
};

/// Whether the kind's parameter has the word among its choices.
bool has_choice(const KindInfo& kind, const std::string& parameter, const std::string& word);

/// Every family there is, with the kinds of plugins that were loaded before it is first asked for.
const std::vector<KindRegistry>& kind_registries();
/// The family of a product type; null when there is none.
const KindRegistry* find_registry(const std::string& type);

}  // namespace vug::loading
