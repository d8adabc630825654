// Diagnostics as people read them.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::scene {

/// For each diagnostic "file:line:column: error: message", the line it stands on, a caret, and
/// "hint: ..."; in the order of the sources, then of lines and columns, each once, at most
/// `limit` with a last line that counts the rest (of which the parser keeps a hundred). Ends in a
/// newline unless empty.
std::string report(const Diagnostics& diagnostics,
                   const std::vector<std::shared_ptr<const Source>>& sources, int limit = 20);

}  // namespace vug::scene
