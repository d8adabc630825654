// SPDX-License-Identifier: Apache-2.0
// Lookups in the parameters of kinds.
#pragma once

#include <vug/base/schema.h>

#include <string>
#include <string_view>

namespace vug::loading {

/// The parameter of an argument that is given by name or (if the name is empty) by position; null
/// if the kind does not have it.
const ParamInfo* find_param(const KindInfo& kind, size_t position, const std::string& name);

/// The type without "list of ".
std::string_view element_type(std::string_view type);

}  // namespace vug::loading
