// SPDX-License-Identifier: Apache-2.0
// Binds a `grammar NAME: lsystem { ... }`, which other declarations derive and draw.
#pragma once

#include <vug/loading/reader.h>

namespace vug::loading {

/// An LSystemPtr; an empty value if the text has faults. The plan is added to Shot::lsystems, where
/// `vug derive` finds it.
Value bind_lsystem(const scene::Grammar& grammar, ReadContext& context);

}  // namespace vug::loading
