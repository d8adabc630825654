// `grammar NAME: facade { ... }` of a scene: derived at once into rectangles and elements.
#pragma once

#include <vug/loading/reader.h>

namespace vug::loading {

/// What a facade's block may set beside its axiom and rules.
const KindInfo& facade_info();

/// The facade as a field, a wall with everything carved into it (see facade/carve.h); nothing where
/// the text has faults. Its derivation is added to the shot.
Value bind_facade(const scene::Grammar& grammar, ReadContext& context);

}  // namespace vug::loading
