// `grammar NAME: lsystem { ... }` of a scene: a system that other declarations derive and draw.
#pragma once

#include <vug/loading/reader.h>

namespace vug::loading {

/// An LSystemPtr; nothing where the text has faults. The plan joins the shot, where `vug derive`
/// finds it.
Value bind_lsystem(const scene::Grammar& grammar, ReadContext& context);

}  // namespace vug::loading
