// Faults of an L-system's text that show without evaluating anything.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/lsystem_document.h>

#include <functional>

namespace vug::scene {

/// False after a report, for names that nothing may have.
using NameAllowed = std::function<bool(const std::string& name, const SourceLocation& where)>;

/// Formals given twice or called like words of the language, modules with another number of
/// parameters than their rules have, turns of tables that there are not, both lists of what
/// contexts see.
void check_lsystem(const LSystem& system, const NameAllowed& allowed, Diagnostics& diagnostics);

}  // namespace vug::scene
