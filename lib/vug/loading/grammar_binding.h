// SPDX-License-Identifier: Apache-2.0
// Binds a `grammar NAME { ... }` of shapes, which is derived at once into a field.
#pragma once

#include <vug/loading/reader.h>

namespace vug::loading {

/// The options of a grammar block other than its axiom and rules; all except `steps` and `limit`
/// are clauses of an item as well.
const KindInfo& grammar_info();

constexpr int64_t kMaxProductions = 100'000,
                  kMaxSymbols = 1'000'000;  ///< Defaults of `steps` and `limit`.

/// Derives the grammar, adds the derivation to the shot and returns the field. L-systems and
/// facades are passed to bind_lsystem and bind_facade.
Value bind_grammar(const scene::Grammar& grammar, ReadContext& context);

}  // namespace vug::loading
