// SPDX-License-Identifier: Apache-2.0
// Formats diagnostics for users, with the underlined line and its caret.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::scene {

/// For each diagnostic: "file:line:column: error: message", the source line, its range underlined
/// (a caret at the start, then "~~~" as far as the line has it), and "hint: ...". Sorted by source,
/// line and column, without duplicates; at most `limit` diagnostics and a last line with the number
/// of the others (of which the parser keeps a hundred). Ends in a newline unless empty.
std::string report(const Diagnostics& diagnostics,
                   const std::vector<std::shared_ptr<const Source>>& sources, int limit = 20);

}  // namespace vug::scene
