// SPDX-License-Identifier: Apache-2.0
// The words of the scene language that are not kinds, with their use and description.
#pragma once

#include <string>
#include <vector>

namespace vug::language {

/// A word of the language itself.
struct LanguageWord {
  const char* name;
  const char* use;  ///< How it is written.
  const char* doc;
};
/// The words that begin statements other than declarations: param, let, ...
const std::vector<LanguageWord>& statement_words();
/// The words inside statements: in, on, where, ...
const std::vector<LanguageWord>& inner_words();
/// Calls with a meaning of their own, and constants: if, pick, keys, pi, ...
const std::vector<LanguageWord>& value_words();
const LanguageWord* find_word(const std::vector<LanguageWord>& words, const std::string& name);

}  // namespace vug::language
