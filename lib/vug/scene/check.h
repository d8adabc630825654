// SPDX-License-Identifier: Apache-2.0
// Checks that need the whole document: duplicate, reserved and unused names, and the symbols of
// grammars.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>

#include <string>

namespace vug::scene {

/// True if the name is neither a unit nor a keyword.
bool may_name(const std::string& name);

/// Reports duplicate names, names that are units or keywords, grammars without an axiom, and calls
/// of symbols with the wrong number of arguments. Marks ambiguous names in `document.skipped` and
/// erroneous grammars as broken. Called by `parse`.
void check_names(Document& document, Diagnostics& diagnostics);

/// Warns of each `param`, `let` and `def` of the scene file that occurs neither in an expression of
/// the document nor in skipped text. Included files may declare names for other scenes.
void check_unused_names(const Document& document, Diagnostics& diagnostics);

}  // namespace vug::scene
