// SPDX-License-Identifier: Apache-2.0
// Renames across the texts that include each other.
#pragma once

#include <vug/language/workspace.h>

#include <map>
#include <string>
#include <vector>

namespace vug::language {

/// The range of the name that a rename at the position would change. Throws Error(bad_input) with
/// the reason if it cannot be renamed.
SourceLocation renamable_at(const Analysis& analysis, const Position& position);

/// The edits of a rename, by file. Throws Error(bad_input) if the new name is not a name, if a text
/// has syntax errors that may hide uses, or if the name already means something where it is used.
std::map<std::string, std::vector<TextEdit>> rename(const Workspace& workspace,
                                                    const Analysis& analysis,
                                                    const Position& position,
                                                    const std::string& new_name);

/// The edits on a text with one of the edits applied, for tests of clashes and for previews.
Workspace with_edits(const Workspace& workspace,
                     const std::map<std::string, std::vector<TextEdit>>& edits);

}  // namespace vug::language
