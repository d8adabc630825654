// SPDX-License-Identifier: Apache-2.0
// The values of the parameters and lets of a text, as far as they do not need objects.
#pragma once

#include <vug/language/workspace.h>

#include <map>
#include <string>

namespace vug::language {

/// The values by the full names of params and lets: "0.3m", "(1, 2, 3)". Names with errors, and
/// those whose values contain objects, are omitted. Nothing is built or read from files.
std::map<std::string, std::string> values_of(const Analysis& analysis);

}  // namespace vug::language
