// Inside session/ only: kinds that join their families later than those that come with us.
#pragma once

#include <vug/loading/kind_registry.h>

#include <string>
#include <utility>
#include <vector>

namespace vug::loading {

/// Adds kinds to the families of these types, all or none. Error(bad_input) with what comes after
/// "the plugin ...": there is no such family, a kind of that name is in one of its own already, or
/// the families were asked for before.
void add_kinds(const std::vector<std::pair<std::string, RegisteredKind>>& kinds);

}  // namespace vug::loading
