// Stages that cannot end.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// False, with an error, where a stage without a depth must go on for ever: a symbol whose every
/// rule makes, without any condition, in the end that symbol again (A -> B, B -> A + F).
bool check_termination(const System& system, Diagnostics& diagnostics);

}  // namespace vug::lsystem
