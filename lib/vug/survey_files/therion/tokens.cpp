// SPDX-License-Identifier: Apache-2.0
#include <vug/base/utf8.h>
#include <vug/survey_files/therion/tokens.h>

namespace vug::survey::therion {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

/// The locations of tokens, from left to right; columns count characters of UTF-8.
class ColumnCounter {
 public:
  ColumnCounter(const SourceLocation& line, const std::string& text) : line_(line), text_(text) {}

  SourceLocation range(size_t start, size_t end) {
    SourceLocation result = line_;
    result.column = column(start);
    result.end_line = line_.line;
    result.end_column = column(end);
    return result;
  }

 private:
  int column(size_t at) {
    for (; counted_ < at; ++counted_)
      if (!is_utf8_tail(text_[counted_])) ++characters_;
    return characters_ + 1;
  }
  const SourceLocation& line_;
  const std::string& text_;
  size_t counted_ = 0;
  int characters_ = 0;
};

}  // namespace

bool Tokens::next() {
  tokens_.clear();
  while (lines_.next()) {
    const auto line = to_utf8(lines_.line(), encoding_);
    if (!line)
      fail("the line has characters that its encoding does not", lines_.at(),
           "name the encoding at the start of the file, such as 'encoding iso8859-1'");
    if (line->find('\0') != std::string::npos)
      fail("the line contains a zero byte", lines_.at(), "expected a text file");
    const bool continues = add_tokens(*line);
    if (!tokens_.empty() && !continues) return true;
  }
  return !tokens_.empty();
}

bool Tokens::add_tokens(const std::string& line) {
  const SourceLocation whole = lines_.at();
  ColumnCounter columns(whole, line);
  size_t at = 0;
  while (true) {
    while (at < line.size() && is_space(line[at])) ++at;
    if (at == line.size() || line[at] == '#') return false;
    if (line[at] == '\\' && line.find_first_not_of(" \t", at + 1) == std::string::npos) return true;
    const size_t start = at;
    Token token;
    if (line[at] == '"') {
      token.kind = Token::Kind::quoted;
      for (++at; at < line.size(); ++at) {
        if (line[at] == '"' && at + 1 < line.size() && line[at + 1] == '"')
          ++at;
        else if (line[at] == '"')
          break;
        token.text += line[at];
      }
      if (at == line.size())
        fail("a text in quotes is not closed", columns.range(start, at), "add a quote");
      ++at;
    } else if (line[at] == '[') {
      token.kind = Token::Kind::bracketed;
      const size_t end = line.find(']', at);
      if (end == std::string::npos)
        fail("a bracket is not closed", columns.range(start, line.size()), "add ']'");
      token.text = line.substr(at + 1, end - at - 1);
      at = end + 1;
    } else {
      while (at < line.size() && !is_space(line[at]) && line[at] != '#') ++at;
      if (at < line.size() || line[at - 1] != '\\') {
        token.text = line.substr(start, at - start);
      } else {
        token.text = line.substr(start, at - 1 - start);
        token.where = columns.range(start, at - 1);
        tokens_.push_back(std::move(token));
        return true;
      }
    }
    token.where = columns.range(start, at);
    tokens_.push_back(std::move(token));
  }
}

}  // namespace vug::survey::therion
