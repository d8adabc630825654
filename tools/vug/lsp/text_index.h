// SPDX-License-Identifier: Apache-2.0
// Converts positions of clients, which count code units, to those of scenes, which count
// characters.
#pragma once

#include <vug/language/position.h>

#include <string>
#include <string_view>
#include <vector>

namespace vug::lsp {

enum class Encoding { utf16, utf8 };

/// A position of the Language Server Protocol: both numbers count from 0.
struct ClientPosition {
  int line = 0;
  int character = 0;  ///< In code units of the encoding.
  bool operator==(const ClientPosition&) const = default;
};

/// The lines of a text.
class TextIndex {
 public:
  TextIndex(std::string text, Encoding encoding);

  /// Positions beyond the end of a line or of the text mean that end.
  ClientPosition to_client(const language::Position& position) const;
  language::Position from_client(const ClientPosition& position) const;
  /// The number of code units of a part of a line.
  int units(std::string_view text) const;
  const std::string& text() const { return text_; }
  int lines() const { return static_cast<int>(starts_.size()); }

 private:
  std::string_view line(int number) const;

  std::string text_;
  std::vector<size_t> starts_;
  Encoding encoding_;
};

}  // namespace vug::lsp
