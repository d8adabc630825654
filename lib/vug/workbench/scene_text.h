// SPDX-License-Identifier: Apache-2.0
// A scene text as an immutable value, and changes of it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace vug::workbench {

/// UTF-8 with "\n" as line ends. Copies share the text and are cheap.
using SceneText = std::shared_ptr<const std::string>;

/// Replaces `removed` bytes from `begin`.
struct TextChange {
  size_t begin = 0;
  size_t removed = 0;
  std::string text;

  size_t end() const { return begin + text.size(); }  ///< The end in the new text.
  bool empty() const { return removed == 0 && text.empty(); }
};

/// The smallest change of whole characters that turns one text into another.
TextChange change_between(const std::string& before, const std::string& after);
/// Error(bad_input) for a range outside of the text or inside of a character.
std::string with_change(const std::string& text, const TextChange& change);

/// The lines of the new text in which it differs from the old one: "line 3" or "lines 3 to 7".
std::string changed_lines(const std::string& before, const std::string& after);

/// How a file stores a text, so that saving keeps its conventions.
struct FileConventions {
  bool crlf = false;  ///< Lines end with "\r\n".
  bool mark = false;  ///< The file begins with the byte order mark of UTF-8.
};
FileConventions conventions_of(const std::string& file_text);
/// The bytes of the file for a text.
std::string with_conventions(const std::string& text, const FileConventions& conventions);

}  // namespace vug::workbench
