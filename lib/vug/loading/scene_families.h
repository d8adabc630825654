// SPDX-License-Identifier: Apache-2.0
// Inside loading only: the registries of the families of kinds that scenes call, as listed in
// lib/families.cmake.
#pragma once

#include <vug/loading/kind_registry.h>

#include <algorithm>
#include <vector>

namespace vug::loading {

/// The registries in the order of the list; families of one product type share a registry.
std::vector<KindRegistry> scene_families();

/// Adds the kinds to the registry of their product type, which it creates if it is missing.
template <class Product>
void add_family(std::vector<KindRegistry>& all, const Kinds<Product>& kinds) {
  const std::string type = ValueTraits<Product>::type();
  auto registry = std::find_if(all.begin(), all.end(),
                               [&](const KindRegistry& each) { return each.type == type; });
  if (registry == all.end()) registry = all.insert(all.end(), KindRegistry{type, {}});
  for (const Kind<Product>* kind : kinds) registry->kinds.push_back(registered_kind(*kind));
}

}  // namespace vug::loading
