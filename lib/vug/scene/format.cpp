// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/format.h>
#include <vug/scene/format_columns.h>
#include <vug/scene/format_lsystem.h>
#include <vug/scene/lexer.h>

#include <algorithm>
#include <set>

namespace vug::scene {

namespace {

bool one_of(std::string_view text, std::initializer_list<std::string_view> all) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

bool is_arithmetic(const Token& t) {
  return t.kind == TokenKind::sign && one_of(t.text, {"+", "-", "*", "/", "^", "&", "~"});
}

bool is_word(const Token& t) {
  return t.kind == TokenKind::name && one_of(t.text, {"and", "or", "not", "in", "on", "if"});
}

/// True if an operand can end at the token, so that a following sign is a binary operator.
bool ends_operand(const Token& t) {
  if (t.kind == TokenKind::sign) return t.is(")") || t.is("]");
  return t.kind != TokenKind::comment && !is_word(t);
}

class Formatter {
 public:
  explicit Formatter(const std::vector<Token>& tokens)
      : tokens_(tokens), marks_(mark_lsystems(tokens)) {}

  std::string run() {
    find_heads();
    int breaks = 0;
    for (size_t at = 0; tokens_[at].kind != TokenKind::end;) {
      if (is_break(tokens_[at])) {
        ++breaks;
        ++at;
        continue;
      }
      size_t end = at;
      while (tokens_[end].kind != TokenKind::end && !is_break(tokens_[end])) ++end;
      line(at, end);
      rows_.back().blank_before = breaks > 1;
      breaks = 0;
      at = end;
    }
    return align_columns(rows_);
  }

 private:
  struct Open {
    char sign;
    bool grammar;
    int indent;  ///< Indent of the line that opened it.
  };

  static bool is_break(const Token& t) { return t.kind == TokenKind::newline && t.text != ";"; }

  bool in_braces() const { return !open_.empty() && open_.back().sign == '{'; }
  bool in_grammar() const { return in_braces() && open_.back().grammar; }
  bool in_brackets() const { return !open_.empty() && open_.back().sign != '{'; }

  void line(size_t begin, size_t end) {
    FormattedLine row;
    if (tokens_[end - 1].kind == TokenKind::comment) {
      --end;
      row.comment = std::string(tokens_[end].text);
      row.comment.erase(row.comment.find_last_not_of(" \t") + 1);
    }
    row.indent = begin == end ? inside() : indent(begin);
    if (begin < end) {
      items_ = in_grammar() && has_items(begin, row.indent);
      fill(row, begin, end);
    }
    rows_.push_back(std::move(row));
  }

  /// Brackets opened on the same line add a single indent.
  int inside() const { return open_.empty() ? 0 : open_.back().indent + 2; }

  int indent(size_t begin) const {
    const Token& first = tokens_[begin];
    const bool closes = first.is(")") || first.is("]") || first.is("}");
    if (closes && !open_.empty()) return open_.back().indent;
    if (marks_[begin].inside && !in_brackets())
      return inside() + (marks_[begin].goes_on || hanging_ ? 4 : 0);
    const bool goes_on = is_arithmetic(first) || first.is(".") || first.is("->") ||
                         (first.is("=") && open_.empty()) || is_word(first) || first.is(",") ||
                         is_where(first) || (first.kind == TokenKind::text && open_.empty()) ||
                         (in_grammar() && ((items_ && is_clause(first)) || is_symbol(begin)));
    return inside() + ((goes_on || hanging_) && !in_brackets() ? 4 : 0);
  }

  /// The token after line breaks.
  const Token& beyond_breaks(size_t at) const {
    while (is_break(tokens_[at])) ++at;
    return tokens_[at];
  }

  /// True if the line is a rule: it contains an arrow, or the next line starts with one.
  bool is_rule(size_t begin) const {
    size_t i = begin;
    for (; tokens_[i].kind != TokenKind::end && tokens_[i].kind != TokenKind::newline; ++i)
      if (tokens_[i].is("->")) return true;
    return beyond_breaks(i).is("->");
  }

  /// Names that start a rule somewhere; a line that starts with one but is not a rule continues the
  /// items of the previous rule.
  void find_heads() {
    for (size_t i = 0; i < tokens_.size(); ++i) {
      const bool first = i == 0 || tokens_[i - 1].kind == TokenKind::newline;
      if (first && tokens_[i].kind == TokenKind::name && is_rule(i)) heads_.insert(tokens_[i].text);
    }
  }

  /// At the start of a line: the local names of a function or a rule.
  bool is_where(const Token& first) const {
    return first.is_name("where") && (open_.empty() || in_grammar()) && !heads_.count("where");
  }

  bool is_symbol(size_t begin) const {
    return heads_.count(tokens_[begin].text) > 0 && !is_rule(begin);
  }

  /// Whether the line's items may continue on the next line: an axiom, a rule, or a continuation.
  bool has_items(size_t begin, int indent) const {
    return tokens_[begin].is_name("axiom") || is_rule(begin) || (items_ && indent > inside());
  }

  /// The second word of `by rock {`.
  bool is_rock(size_t i) const {
    return i > 0 && tokens_[i - 1].is_name("by") && tokens_[i].is_name("rock") &&
           tokens_[i + 1].is("{");
  }

  static bool is_clause(const Token& t) { return t.is_name("label") || t.is_name("blend"); }

  void fill(FormattedLine& row, size_t begin, size_t end) {
    row.kind = kind(begin, end);
    row.cells.emplace_back();
    bool key = false;  // the previous token is an entry's key
    for (size_t i = begin; i < end; ++i) {
      const Token& token = tokens_[i];
      const bool starts_entry = in_braces() && !in_grammar() && token.kind == TokenKind::name &&
                                !is_word(token) && !is_rock(i) && !key &&
                                (i == begin ? !hanging_ : ends_entry(tokens_[i - 1]));
      if (i > begin) {
        if (breaks_cell(row, i, key)) {
          row.cells.resize(cell(row, i) + 1);
        } else {
          const bool wide = starts_entry && ends_operand(tokens_[i - 1]);
          const bool index = !key && is_index(i);
          const int space = wide ? 2 : index ? 0 : gap(begin, i);
          row.cells.back().append(static_cast<size_t>(space), ' ');
        }
      }
      row.cells.back() += token.text;
      key = starts_entry;
      track(i, begin, row.indent);
    }
    const Token& last = tokens_[end - 1];
    hanging_ = !marks_[end - 1].module && (is_arithmetic(last) || last.is(",") || last.is("=") ||
                                           last.is("->") || last.is("..") || is_word(last));
  }

  static bool ends_entry(const Token& before) {
    return ends_operand(before) || before.is("{") || before.kind == TokenKind::newline;
  }

  void track(size_t at, size_t begin, int indent) {
    const Token& token = tokens_[at];
    if (token.kind != TokenKind::sign) return;
    if (marks_[at].module && !token.is("(") && !token.is(")")) return;  // the turtle's brackets
    const char sign = token.text[0];
    const bool grammar = tokens_[begin].is_name("grammar") || marks_[at].inside;
    if (one_of(token.text, {"(", "[", "{"}))
      open_.push_back({sign, sign == '{' && grammar, indent});
    if (one_of(token.text, {")", "]", "}"}) && !open_.empty()) open_.pop_back();
  }

  /// The kind of the line if such lines are aligned.
  std::string kind(size_t begin, size_t end) const {
    const Token& first = tokens_[begin];
    if (marks_[begin].inside && marks_[begin].goes_on) return {};
    const bool sign = marks_[begin].module;  // a rule of "+"
    if ((first.kind != TokenKind::name && !sign) || hanging_ || is_word(first)) return {};
    for (size_t i = begin; i < end; ++i)
      if (tokens_[i].text == ";") return {};
    if (in_grammar()) return holds("->", begin, end) ? "rule" : "";
    if (in_braces()) return entries(begin, end) == 1 ? "entry" : "";
    if (!open_.empty()) return {};
    if (end - begin > 2 && tokens_[begin + 2].is("=")) {
      if (first.text == "param") return "param";
      return "= " + std::string(first.text);
    }
    return {};
  }

  bool holds(std::string_view sign, size_t begin, size_t end) const {
    for (size_t i = begin; i < end; ++i)
      if (tokens_[i].is(sign)) return true;
    return false;
  }

  /// The number of entries that start on the line; 2 if it contains a brace.
  int entries(size_t begin, size_t end) const {
    int count = 1, depth = 0;
    for (size_t i = begin + 2; i < end; ++i) {
      const Token& t = tokens_[i];
      if (t.is("{") || t.is("}")) return 2;
      if (t.is("(") || t.is("[")) ++depth;
      if (t.is(")") || t.is("]")) --depth;
      const bool name = t.kind == TokenKind::name && !is_word(t);
      if (depth == 0 && name && ends_entry(tokens_[i - 1])) ++count;
    }
    return count;
  }

  bool breaks_cell(const FormattedLine& row, size_t i, bool key) const {
    const size_t now = row.cells.size() - 1;
    return cell(row, i) > now && (row.kind != "entry" || key);
  }

  /// The cell that token `i` belongs to.
  size_t cell(const FormattedLine& row, size_t i) const {
    const size_t now = row.cells.size() - 1;
    const Token& t = tokens_[i];
    if (row.kind.empty()) return now;
    if (row.kind == "entry") return in_braces() ? std::max<size_t>(now, 1) : now;
    if (row.kind == "rule") {
      if (!in_braces()) return now;
      if (now < 3 && t.is("->")) return 3;
      if (now == 3 && is_clause(t)) return 4;
      if (now < 2 && (t.is_name("if") || (marks_[i].inside && t.is_name("after")))) return 2;
      return now < 1 && t.is("@") ? 1 : now;
    }
    if (!open_.empty()) return now;
    if (now < 1 && t.is("=")) return 1;
    if (row.kind != "param") return now;
    if (now == 1 && t.is_name("in")) return 2;
    const bool doc = t.kind == TokenKind::text && ends_operand(tokens_[i - 1]);
    return doc && now >= 1 && now < 3 ? 3 : now;
  }

  /// The bracket of `list[index]` or of a declaration's loop.
  bool is_index(size_t i) const {
    const Token& t = tokens_[i];
    return t.is("[") && t.touches && !marks_[i].module && ends_operand(tokens_[i - 1]);
  }

  /// Number of spaces before token `i`, which is not the first of its line.
  int gap(size_t begin, size_t i) const {
    const Token& before = tokens_[i - 1];
    const Token& t = tokens_[i];
    if (marks_[i].module && marks_[i - 1].module) return t.touches || t.is("(") ? 0 : 1;
    if (marks_[i].module || marks_[i - 1].module) {
      if (before.is("(") || t.is(")") || t.is(",") || t.text == ";") return 0;
      return 1;
    }
    if (before.is("(") || before.is("[")) return 0;
    if (t.is(")") || t.is("]") || t.is(",") || t.is(":") || t.text == ";") return 0;
    if (before.is("{") && t.is("}")) return 0;
    if (before.is(".") || t.is(".") || before.is("..") || t.is("..") || before.is("@")) return 0;
    if (is_arithmetic(before) && t.touches) {
      const bool unary = i < begin + 2 || !ends_operand(tokens_[i - 2]);
      const bool sign = before.is("+") || before.is("-");
      if (unary || before.touches || sign) return 0;
    }
    if (is_arithmetic(t) && ends_operand(before) && t.touches && tokens_[i + 1].touches) return 0;
    if (t.is("(") && before.kind == TokenKind::name && t.touches) return 0;
    return 1;
  }

  const std::vector<Token>& tokens_;
  std::vector<LSystemToken> marks_;  ///< By token.
  std::vector<FormattedLine> rows_;
  std::vector<Open> open_;
  std::set<std::string_view> heads_;
  bool items_ = false;    ///< The previous line has items that a clause may continue.
  bool hanging_ = false;  ///< The previous line ends within an expression or list.
};

}  // namespace

std::string format(std::string_view text) {
  const std::string normal = normalise_text(std::string(text));
  Diagnostics ignored;
  const std::vector<Token> tokens = lex(normal, {}, ignored, true);
  return Formatter(tokens).run();
}

}  // namespace vug::scene
