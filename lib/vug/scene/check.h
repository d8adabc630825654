// Faults that show only in the whole document.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

#include <string>

namespace vug::scene {

/// True for a name that is neither a unit nor a word of the language.
bool may_name(const std::string& name);

/// Names given twice, names that are units, symbols of a grammar without a rule, calls of
/// symbols with the wrong number of arguments; marks what is in doubt by that. `parse` runs it.
void check_names(Document& document, Diagnostics& diagnostics);

/// An error for each parameter whose name stands in no expression of the document, and
/// in nothing that was lost.
void check_params_read(const Document& document, Diagnostics& diagnostics);

}  // namespace vug::scene
