// The cut symbol: what stands behind a "%" in its branch falls off.
#pragma once

#include <vug/lsystem/rewriting.h>

namespace vug::lsystem {

/// Takes out each "%" of the system with all that follows it up to the bracket that closes its
/// branch, or up to the end of the word. Side branches in between go too.
void cut_branches(const System& system, Derivation& derivation);

}  // namespace vug::lsystem
