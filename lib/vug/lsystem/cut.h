// SPDX-License-Identifier: Apache-2.0
// The cut symbol "%", which removes the rest of its branch.
#pragma once

#include <vug/lsystem/rewriting.h>

namespace vug::lsystem {

/// Removes each "%" and everything after it up to the bracket that closes its branch, or up to the
/// end of the word, including side branches.
void cut_branches(const System& system, Derivation& derivation);

}  // namespace vug::lsystem
