// Faults and warnings as Python sees them: vug.Error, vug.Cancelled, vug.SceneWarning.
#pragma once

#include "binding.h"

#include <vug/base/diagnostics.h>
#include <vug/loading/load.h>

#include <string>
#include <vector>

namespace vug::python {

/// Throws the faults of a text as one vug.Error, which lists them all and is placed at the first.
[[noreturn]] void raise(const loading::Loaded& faulty);

/// Tells warnings through Python's `warnings`, as from the line that called us. Throws where its
/// filters make errors of them.
void warn(const std::vector<std::string>& texts);

/// The diagnostics that are no errors, one text each, with their lines and carets.
std::vector<std::string> warnings_of(const loading::Loaded& loaded, const Diagnostics& diagnostics);

}  // namespace vug::python
