// A grammar block of a scene, derived into a field.
#pragma once

#include <vug/loading/reader.h>

namespace vug::loading {

/// What a grammar block may set beside its axiom and rules; all but `steps` and `limit` are clauses
/// of an item, too.
const KindInfo& grammar_info();

constexpr int64_t kMaxProductions = 100'000, kMaxSymbols = 1'000'000;  ///< Unless a block says.

/// Derives the grammar and gives its field; the derivation is added to the shot. L-systems
/// and facades are bound by bind_lsystem and bind_facade.
Value bind_grammar(const scene::Grammar& grammar, ReadContext& context);

}  // namespace vug::loading
