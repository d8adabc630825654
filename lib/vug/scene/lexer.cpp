// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/scene/lexer.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

namespace vug::scene {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Characters that are often pasted from word processors, with hints.
struct Lookalike {
  std::string_view character;
  const char* hint;
};
constexpr Lookalike kLookalikes[] = {
    {"\u2212", "write the minus sign as '-'"}, {"\u2013", "write the minus sign as '-'"},
    {"\u2014", "write the minus sign as '-'"}, {"\u201c", "write quotes as '\"'"},
    {"\u201d", "write quotes as '\"'"},        {"\u00d7", "write sizes with the letter x: 4x3"},
    {"\u00b0", "write degrees as deg"},        {"\u2192", "write the arrow as '->'"},
    {"\u2026", "write the range as '..'"},     {"\u00a0", "this is a no-break space"},
};

class Lexer {
 public:
  Lexer(std::string_view text, const std::string& file, Diagnostics& diagnostics, bool comments,
        int max_errors)
      : text_(text),
        file_(file),
        diagnostics_(diagnostics),
        comments_(comments),
        errors_left_(max_errors) {}

  std::vector<Token> run() {
    while (at_ < text_.size()) step();
    begin();
    push(TokenKind::end, 0);
    return std::move(tokens_);
  }

 private:
  char look(size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  void step() {
    const char c = look();
    if (is_blank(c)) {
      advance(1);
      touches_ = false;
      return;
    }
    begin();
    if (c == '\n' || c == ';') return push(TokenKind::newline, 1);
    if (c == '#') return is_colour() ? colour() : comment();
    if (c == '/' && (look(1) == '/' || look(1) == '*') && braces_ == 0) return foreign_comment();
    if (is_digit(c) || (c == '.' && is_digit(look(1)))) return number();
    if (is_letter(c)) return push(TokenKind::name, word(0));
    if (c == '"') return quoted();
    if (const size_t length = sign(); length > 0) return push(TokenKind::sign, length);
    junk();
  }

  void begin() { line_start_ = {line_, column_}; }

  /// Adds a token of the next `length` bytes.
  void push(TokenKind kind, size_t length, Number value = {}) {
    Token token;
    token.kind = kind;
    token.text = text_.substr(at_, length);
    token.line = line_start_.line;
    token.column = line_start_.column;
    token.touches = touches_;
    token.number = value;
    token.faulty = !faults_.empty();
    tokens_.push_back(token);
    report(token);
    if (token.is("{") && (braces_ > 0 || opens_lsystem())) ++braces_;
    if (token.is("}") && braces_ > 0) --braces_;
    advance(length);
    touches_ = kind != TokenKind::newline;
  }

  /// True if the last token is the brace of `grammar NAME: lsystem {`.
  bool opens_lsystem() const {
    std::vector<const Token*> before;
    for (size_t i = tokens_.size() - 1; i-- > 0 && before.size() < 4;) {
      const Token& token = tokens_[i];
      if (token.kind == TokenKind::comment || token.text == "\n") continue;
      before.push_back(&token);
    }
    return before.size() == 4 && before[0]->is_name("lsystem") && before[1]->is(":") &&
           before[2]->kind == TokenKind::name && before[3]->is_name("grammar");
  }

  void advance(size_t length) {
    for (size_t i = 0; i < length; ++i) {
      const char c = text_[at_++];
      if (c == '\n') {
        ++line_;
        column_ = 1;
      } else if (!is_utf8_tail(c)) {
        ++column_;
      }
    }
  }

  /// Reports the faults of a token, now that its end is known.
  void report(const Token& token) {
    for (Fault& fault : faults_)
      if (errors_left_-- > 0)
        diagnostics_.error({file_, token.line, token.column, token.end_line(), token.end_column()},
                           std::move(fault.message), std::move(fault.hint));
    faults_.clear();
  }

  void error(std::string message, std::string hint = {}) {
    faults_.push_back({std::move(message), std::move(hint)});
  }

  void comment() {
    const size_t length = rest_of_line();
    if (comments_) return push(TokenKind::comment, length);
    advance(length);
    touches_ = false;
  }

  size_t rest_of_line() const {
    size_t length = 0;
    while (at_ + length < text_.size() && look(length) != '\n') ++length;
    return length;
  }

  /// Whether a colour in the notation of web pages is written where a value is expected: 3 or 6
  /// hexadecimal digits. A word of letters only, such as "#bad", may begin a comment.
  bool is_colour() const {
    const std::string_view digits = text_.substr(at_ + 1, word(1));
    const auto is_hex = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
    if ((digits.size() != 3 && digits.size() != 6) ||
        !std::all_of(digits.begin(), digits.end(), is_hex) ||
        std::none_of(digits.begin(), digits.end(), is_digit) || tokens_.empty())
      return false;
    const Token& before = tokens_.back();
    const bool same_line = before.line == line_ && before.text != "\n";
    return same_line && (before.kind == TokenKind::name || before.is(":") || before.is(",") ||
                         before.is("(") || before.is("[") || before.is("="));
  }

  /// Reports such a colour with the function that reads it.
  void colour() {
    const size_t length = 1 + word(1);
    error("'#' starts a comment, not a colour",
          fmt::format("write srgb(\"{}\")", text_.substr(at_, length)));
    push(TokenKind::junk, length);
  }

  /// Reports a comment in the notation of C and skips it.
  void foreign_comment() {
    const std::string sign(text_.substr(at_, 2));
    error(fmt::format("'{}' does not start a comment", sign), "comments start with '#'");
    const size_t end = sign == "/*" ? text_.find("*/", at_ + 2) : text_.npos;
    push(TokenKind::junk, end == text_.npos ? rest_of_line() : end + 2 - at_);
    tokens_.pop_back();  // so that the rest of the text is parsed
    touches_ = false;
  }

  /// Length of the word that starts `from` bytes ahead.
  size_t word(size_t from) const {
    size_t length = from;
    while (is_letter(look(length)) || is_digit(look(length))) ++length;
    return length - from;
  }

  size_t digits(size_t from) const {
    size_t length = from;
    while (is_digit(look(length))) ++length;
    return length - from;
  }

  void number() {
    size_t length = digits(0);
    if (length > 0 && look(length) == 'x' && is_digit(look(length + 1)))
      return push(TokenKind::size, length + 1 + digits(length + 1));
    if (look(length) == '.' && is_digit(look(length + 1))) length += 1 + digits(length + 1);
    if (look(length) == 'e' || look(length) == 'E') {
      const size_t sign = look(length + 1) == '-' || look(length + 1) == '+' ? 1 : 0;
      if (const size_t power = digits(length + 1 + sign); power > 0) length += 1 + sign + power;
    }
    double value = 0;
    const char* first = text_.data() + at_;
    const auto parsed = std::from_chars(first, first + length, value);
    if (parsed.ec == std::errc::result_out_of_range) {
      // Underflow gives 0; from_chars does not distinguish it from overflow, so check the
      // exponent's sign.
      const std::string_view written = text_.substr(at_, length);
      const size_t e = written.find_first_of("eE");
      const bool tiny = e != std::string_view::npos && written.substr(e).find('-') == 1;
      value = 0;
      if (!tiny) error(fmt::format("the number {} is too large", written.substr(0, 40)));
    }
    const size_t unit = look(length) == '%' ? 1 : word(length);
    Number result{value};
    if (unit > 0) {
      const std::string name(text_.substr(at_ + length, unit));
      if (const auto known = with_unit(value, name))
        result = *known;
      else
        error(fmt::format("unknown unit '{}'", name.substr(0, 40)),
              suggestion(name.substr(0, 40), unit_names()));
    }
    push(TokenKind::number, length + unit, result);
  }

  void quoted() {
    size_t length = 1;
    while (at_ + length < text_.size() && look(length) != '"' && look(length) != '\n') {
      if (look(length) == '\\') {
        const char escape = look(length + 1);
        if (escape == '\n' || escape == '\0') break;
        if (escape != '"' && escape != '\\' && escape != 'n' && escape != 't')
          error("unknown escape in a text", "known: \\\" \\\\ \\n \\t");
        ++length;
      }
      ++length;
    }
    if (look(length) == '"' && at_ + length < text_.size())
      ++length;
    else
      error("a text without a closing quote", "a text must end on the line where it begins");
    length = std::min(length, text_.size() - at_);
    if (!is_utf8(text_.substr(at_, length))) error("invalid UTF-8 in a text");
    push(TokenKind::text, length);
  }

  size_t sign() const {
    const std::string_view two = text_.substr(at_, 2);
    for (const char* known : {"->", "..", "<=", ">=", "==", "!="})
      if (two == known) return 2;
    const auto among = [&](std::string_view signs) {
      return signs.find(look()) != std::string_view::npos;
    };
    return among("()[]{},:=+-*/^&~@.<>") || (braces_ > 0 && among("\\|$!'%?")) ? 1 : 0;
  }

  /// Adds one diagnostic for a run of invalid characters.
  void junk() {
    const std::string_view rest = text_.substr(at_);
    for (const Lookalike& known : kLookalikes) {
      if (rest.substr(0, known.character.size()) != known.character) continue;
      error(fmt::format("unexpected character '{}'", known.character), known.hint);
      return push(TokenKind::junk, known.character.size());
    }
    size_t length = 1;
    const auto is_junk = [&](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte >= 0x80 || (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
    };
    if (is_junk(look()))
      while (length < rest.size() && is_junk(rest[length])) ++length;
    if (length == 1 && !is_junk(look()))
      error(fmt::format("unexpected character '{}'", look()));
    else if (is_utf8(rest.substr(0, length)) && static_cast<unsigned char>(look()) >= 0x80)
      error(fmt::format("unexpected character '{}'", rest.substr(0, utf8_length(rest))),
            "names consist of letters a-z, digits and _; other letters are only allowed in texts "
            "and comments");
    else
      error(length == 1 ? "invalid byte" : "invalid bytes", "scenes are UTF-8 text");
    push(TokenKind::junk, length);
  }

  struct Start {
    int line = 1;
    int column = 1;
  };
  struct Fault {
    std::string message;
    std::string hint;
  };

  std::string_view text_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  bool comments_;
  int errors_left_;
  size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  bool touches_ = false;
  std::vector<Fault> faults_;  ///< The faults of the current token.
  int braces_ = 0;             ///< Open braces of an L-system's block, which has additional signs.
  Start line_start_;
  std::vector<Token> tokens_;
};

}  // namespace

int Token::end_column() const { return text == "\n" ? 1 : column + utf8_count(text); }

std::string normalise_text(std::string text) {
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0) text.erase(0, 3);
  size_t to = 0;
  for (size_t from = 0; from < text.size(); ++from) {
    char c = text[from];
    if (c == '\r') {
      if (from + 1 < text.size() && text[from + 1] == '\n') ++from;
      c = '\n';
    }
    text[to++] = c;
  }
  text.resize(to);
  return text;
}

std::vector<Token> lex(std::string_view text, const std::string& file, Diagnostics& diagnostics,
                       bool keep_comments, int max_errors) {
  return Lexer(text, file, diagnostics, keep_comments, max_errors).run();
}

std::string unquote(std::string_view token) {
  std::string out;
  for (size_t i = 1; i < token.size(); ++i) {
    char c = token[i];
    if (c == '"') break;
    if (c == '\\' && i + 1 < token.size()) {
      c = token[++i];
      if (c == 'n') c = '\n';
      if (c == 't') c = '\t';
    }
    out += c;
  }
  return out;
}

std::optional<Number> read_number(std::string_view text) {
  const bool minus = text.substr(0, 1) == "-";
  if (minus) text.remove_prefix(1);
  Diagnostics faults;
  const std::vector<Token> tokens = lex(text, "", faults);
  const Token& token = tokens.front();
  if (faults.has_errors() || token.kind != TokenKind::number || token.text != text)
    return std::nullopt;
  return Number{minus ? -token.number.value : token.number.value, token.number.dimension};
}

}  // namespace vug::scene
