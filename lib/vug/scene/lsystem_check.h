// SPDX-License-Identifier: Apache-2.0
// Static checks of an L-system's text.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/lsystem_document.h>

#include <functional>

namespace vug::scene {

/// Returns false, after an error, for names that are not allowed.
using NameAllowed = std::function<bool(const std::string& name, const SourceLocation& where)>;

/// Reports duplicate or reserved formals, modules whose number of parameters differs from that of
/// their rules, schedules with unknown tables, and the use of both 'ignore' and 'consider'.
void check_lsystem(const LSystem& system, const NameAllowed& allowed, Diagnostics& diagnostics);

}  // namespace vug::scene
