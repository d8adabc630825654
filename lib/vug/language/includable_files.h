// SPDX-License-Identifier: Apache-2.0
// The scenes that a text can include.
#pragma once

#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

/// The scenes that an include can name, relative to the folders.
std::vector<std::string> includable_files(const Workspace& workspace, const std::string& file);

}  // namespace vug::language
