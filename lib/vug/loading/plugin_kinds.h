// SPDX-License-Identifier: Apache-2.0
// Inside loading only: adds the kinds of plugins to the registries.
#pragma once

#include <vug/loading/kind_registry.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::loading {

/// Adds kinds to the registries of the given product types, all or none. Error(bad_input), with a
/// message that continues "the plugin ...": there is no such registry, it contains a kind of that
/// name, or the registries are already in use.
void add_kinds(const std::vector<std::pair<std::string, RegisteredKind>>& kinds);

}  // namespace vug::loading
