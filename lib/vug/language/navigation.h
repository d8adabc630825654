// SPDX-License-Identifier: Apache-2.0
// Definitions and references across the texts that include each other.
#pragma once

#include <vug/language/workspace.h>

#include <optional>
#include <vector>

namespace vug::language {

/// The symbol at a position of a text: nothing if the word there is not the name of one.
std::optional<Symbol> symbol_at(const Analysis& analysis, const Position& position);

/// The name in the declaration of the symbol at the position, or the beginning of the file that an
/// include names there; an unknown location if there is neither.
SourceLocation definition_at(const Analysis& analysis, const Position& position);

/// The places where the symbol's name is written in one text and the files that it includes.
std::vector<Reference> references_in(const Analysis& analysis, const Symbol& symbol);

/// Those of all texts of the workspace, by file and place, each once.
std::vector<Reference> references_of(const Workspace& workspace, const Analysis& analysis,
                                     const Symbol& symbol);

}  // namespace vug::language
