// A grammar block of a scene, derived into a field.
#pragma once

#include <vug/session/reader.h>

namespace vug::session {

/// Derives the grammar and gives its field; the derivation is added to the shot.
Value bind_grammar(const scene::Grammar& grammar, Reading& reading);

}  // namespace vug::session
