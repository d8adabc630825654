// SPDX-License-Identifier: Apache-2.0
// Errors and warnings in Python: vug.Error, vug.Cancelled, vug.SceneWarning.
#pragma once

#include "binding.h"

#include <vug/base/diagnostics.h>
#include <vug/loading/load.h>

#include <string>
#include <vector>

namespace vug::python {

/// Throws the errors of a text as one vug.Error, which lists all of them and has the location of
/// the first. `faults`: its own, or others found later.
[[noreturn]] void raise(const loading::Loaded& loaded, const Diagnostics& faults);

/// Issues warnings through Python's `warnings`, attributed to the calling line. Throws if the
/// warning filters turn them into errors.
void warn(const std::vector<std::string>& texts);

/// The warnings among the diagnostics, one text each, with source lines and carets.
std::vector<std::string> warnings_of(const loading::Loaded& loaded, const Diagnostics& diagnostics);

}  // namespace vug::python
