// SPDX-License-Identifier: Apache-2.0
// Nouns with their counts and articles, for messages.
#pragma once

#include <string>

namespace vug {

/// "geologies", "boxes", "lights" for their singular.
inline std::string plural_of(const std::string& word) {
  const auto ends_in = [&](char last, const char* before) {
    return word.size() > 1 && word.back() == last &&
           std::string(before).find(word[word.size() - 2]) != std::string::npos;
  };
  if (word.size() > 1 && word.back() == 'y' && !ends_in('y', "aeiou"))
    return word.substr(0, word.size() - 1) + "ies";
  const bool hisses =
      word.ends_with('s') || word.ends_with('x') || word.ends_with("sh") || word.ends_with("ch");
  return word + (hisses ? "es" : "s");
}

/// A type with its article, for messages: "a number", "a list of fields", "points", "true or
/// false".
inline std::string with_article(const std::string& type) {
  if (type == "true or false") return type;
  if (type.starts_with("list of ")) return "a " + plural_of(type);
  if (type.ends_with('s')) return type;  // A plural: points, cells, drips.
  const bool vowel = type.find_first_of("aeio") == 0 || type == "lsystem";  // As it is spoken.
  return (vowel ? "an " : "a ") + type;
}

/// "1 edit", "0 edits", "7 edits".
inline std::string pluralize(size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + (count == 1 ? what : plural_of(what));
}

}  // namespace vug
