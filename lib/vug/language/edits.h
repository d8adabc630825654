// SPDX-License-Identifier: Apache-2.0
// Edits of a text that keep its formatting and comments, for programs whose controls change a
// scene.
#pragma once

#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

/// Replaces the value of a param of the text. Throws Error(bad_input) if the text does not declare
/// it, or if its declaration has a syntax error.
TextEdit set_param(const Analysis& analysis, const std::string& name, const std::string& value);

/// Replaces an argument of the innermost call around the position, or adds it at the end. Arguments
/// by position are found by the parameters of the kind. Throws Error(bad_input) if no call without
/// a syntax error is there.
TextEdit set_argument(const Analysis& analysis, const Position& position, const std::string& name,
                      const std::string& value);

/// Replaces the value of an entry in the block of a declaration, or adds the entry at the end of
/// the block. Throws Error(bad_input) if the text has no such block.
TextEdit set_entry(const Analysis& analysis, const std::string& keyword, const std::string& name,
                   const std::string& key, const std::string& value);

}  // namespace vug::language
