// SPDX-License-Identifier: Apache-2.0
// Binds a `grammar NAME: facade { ... }`, which is derived at once into rectangles and elements.
#pragma once

#include <vug/loading/reader.h>

namespace vug::loading {

/// The options of a facade block other than its axiom and rules.
const KindInfo& facade_info();

/// The facade as a field: a wall with its elements carved in (see facade/carve.h); an empty value
/// if the text has faults. The derivation is added to the shot.
Value bind_facade(const scene::Grammar& grammar, ReadContext& context);

}  // namespace vug::loading
