// Text to tokens, each knowing its place and how it was spaced.
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
  comment,  ///< "#..." up to the line's end; only when asked for.
  number,   ///< With its unit: `number` is in base units.
  size,     ///< 1920x1080
  text,     ///< With its quotes; see `unquote`.
  name,     ///< Letters, digits and _, not starting with a digit.
  sign,     ///< ( ) [ ] { } , : = + - * / ^ & ~ @ . .. -> < <= > >= == != and, in the block of an
            ///< L-system, \ | $ ! ' % ?
  junk      ///< Characters that no text may hold; a diagnostic was given.
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;  ///< As written; views the lexed text.
  int line = 1;           ///< From 1.
  int column = 1;         ///< From 1, in characters (UTF-8), a tab being one.
  bool touches = false;   ///< No space, comment or line break before it.
  Number number;          ///< For TokenKind::number.
  bool faulty = false;    ///< A diagnostic was given of it.

  bool is(std::string_view sign) const { return kind == TokenKind::sign && text == sign; }
  bool is_name(std::string_view name) const { return kind == TokenKind::name && text == name; }
};

/// Line ends become "\n" and a byte order mark goes; what `lex` and `report` expect.
std::string normalise_text(std::string text);

/// Tokens of `text`, which must outlive them. Faults (junk bytes, open quotes, unknown units and
/// escapes) are reported at `file` and passed over; after `max_errors` of them silently.
std::vector<Token> lex(std::string_view text, const std::string& file, Diagnostics& diagnostics,
                       bool keep_comments = false, int max_errors = 100);

/// The characters that a text token stands for.
std::string unquote(std::string_view token);

/// A number alone, as scenes write it but with a sign: "-2", "3%", "90s"; nothing for other texts.
std::optional<Number> read_number(std::string_view text);

}  // namespace vug::scene
