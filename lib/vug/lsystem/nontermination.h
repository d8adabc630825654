// SPDX-License-Identifier: Apache-2.0
// Detection of stages that never terminate.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/lsystem/system.h>

namespace vug::lsystem {

/// Returns false, with an error, if a stage without a depth cannot terminate: a symbol whose rules
/// all, unconditionally, eventually produce that symbol again (A -> B, B -> A + F).
bool check_termination(const System& system, Diagnostics& diagnostics);

}  // namespace vug::lsystem
