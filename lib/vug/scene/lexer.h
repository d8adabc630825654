// SPDX-License-Identifier: Apache-2.0
// Lexer: text to tokens with locations and spacing.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/base/value.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::scene {

enum class TokenKind {
  end,      ///< After the last character; always the last token.
  newline,  ///< A line's end, or ";" in its place.
  comment,  ///< "#..." up to the line's end; only on request.
  number,   ///< With its unit: `number` is in base units.
  size,     ///< 1920x1080
  text,     ///< With its quotes; see `unquote`.
  name,     ///< Letters, digits and _, not starting with a digit.
  sign,     ///< ( ) [ ] { } , : = + - * / ^ & ~ @ . .. -> < <= > >= == != and, in the block of an
            ///< L-system, \ | $ ! ' % ?
  junk      ///< Invalid characters, for which a diagnostic was added.
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;  ///< As written; views the lexed text.
  int line = 1;           ///< From 1.
  int column = 1;         ///< From 1, in characters (UTF-8), a tab being one.
  bool touches = false;   ///< Directly follows the previous token.
  Number number;          ///< For TokenKind::number.
  bool faulty = false;    ///< A diagnostic was added for it.

  /// The line and column after the last character.
  int end_line() const { return text == "\n" ? line + 1 : line; }
  int end_column() const;

  bool is(std::string_view sign) const { return kind == TokenKind::sign && text == sign; }
  bool is_name(std::string_view name) const { return kind == TokenKind::name && text == name; }
};

/// Converts line ends to "\n" and removes a byte order mark, as `lex` and `report` expect.
std::string normalise_text(std::string text);

/// The tokens of `text`, which must outlive them. Errors (invalid bytes, open quotes, unknown units
/// and escapes) are reported with `file` and skipped; only the first `max_errors` are reported.
std::vector<Token> lex(std::string_view text, const std::string& file, Diagnostics& diagnostics,
                       bool keep_comments = false, int max_errors = 100);

/// The text of a text token, with quotes removed and escapes replaced.
std::string unquote(std::string_view token);

/// Parses a single number as in scenes, with an optional sign: "-2", "3%", "90s"; nothing for other
/// texts.
std::optional<Number> read_number(std::string_view text);

}  // namespace vug::scene
