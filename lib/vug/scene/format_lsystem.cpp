// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/format_lsystem.h>

#include <algorithm>

namespace vug::scene {

namespace {

bool is_one_of(const Token& token, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), token.text) != words.end();
}

class Marker {
 public:
  explicit Marker(const std::vector<Token>& tokens) : tokens_(tokens), marks_(tokens.size()) {}

  std::vector<LSystemToken> run() {
    for (at_ = 0; tokens_[at_].kind != TokenKind::end; ++at_) {
      if (blocks_ == 0) {
        if (opens_block()) blocks_ = 1, part_ = Part::fresh;
        continue;
      }
      marks_[at_].inside = true;
      step(tokens_[at_]);
    }
    return std::move(marks_);
  }

 private:
  /// The part of a line to which the next tokens belong.
  enum class Part { fresh, block, option, head, clause, word };

  /// At the brace of `grammar NAME: lsystem {`.
  bool opens_block() const {
    if (!tokens_[at_].is("{")) return false;
    std::vector<const Token*> before;
    for (size_t i = at_; i-- > 0 && before.size() < 3;)
      if (tokens_[i].kind != TokenKind::comment && tokens_[i].kind != TokenKind::newline)
        before.push_back(&tokens_[i]);
    return before.size() == 3 && before[0]->is_name("lsystem") && before[1]->is(":");
  }

  /// Whether the rest of the line contains an arrow, or the next line starts with one.
  bool arrow_ahead() const {
    int depth = 0;
    for (size_t i = at_; tokens_[i].kind != TokenKind::end && !tokens_[i].is("}"); ++i) {
      const Token& token = tokens_[i];
      if (token.is("->")) return true;
      if (token.is("(")) ++depth;
      if (token.is(")")) --depth;
      if (token.kind != TokenKind::newline || depth > 0) continue;
      while (tokens_[i].kind == TokenKind::newline && tokens_[i].text != ";") ++i;
      return tokens_[i].is("->");
    }
    return false;
  }

  void begin_line(const Token& first) {
    const bool open = brackets_ > 0 || polygons_ > 0;
    const bool capital = first.kind == TokenKind::name && first.text[0] <= 'Z';
    const bool is_keyword = is_one_of(first, {"axiom", "ignore", "consider", "ages"});
    if (open) {
      marks_[at_].goes_on = true;
    } else if (first.is("->") || at_where()) {
      marks_[at_].goes_on = true;
      part_ = Part::clause;
    } else if (is_one_of(first, {"table", "decompose", "interpret"}) && !arrow_at_once()) {
      part_ = Part::block;
    } else if (arrow_ahead()) {
      part_ = Part::head;
    } else if (!is_keyword && (first.kind == TokenKind::sign || capital)) {
      marks_[at_].goes_on = true;
      part_ = Part::word;
    } else {
      part_ = Part::option;
    }
    fresh_ = false;
    listing_ = part_ == Part::option && is_keyword;
  }

  /// At the local names of a rule, which are `where NAME =`.
  bool at_where() const {
    return tokens_[at_].is_name("where") && tokens_[at_ + 1].kind == TokenKind::name &&
           tokens_[at_ + 2].is("=");
  }

  bool arrow_at_once() const { return tokens_[at_ + 1].is("->"); }

  void step(const Token& token) {
    if (token.kind == TokenKind::comment) return;
    if (token.kind == TokenKind::newline) {
      if (parens_ == 0) fresh_ = true;
      return;
    }
    if (token.is("}") && (polygons_ == 0 || fresh_)) {  // a leading '}' closes the block
      --blocks_;
      brackets_ = polygons_ = 0;
      fresh_ = true;
      return;
    }
    if (fresh_) {
      begin_line(token);
      if (listing_) {  // modules follow the keyword
        part_ = Part::word;
        return;
      }
    }
    if (part_ == Part::block) {
      if (token.is("{")) ++blocks_, fresh_ = true;
      return;
    }
    if (part_ == Part::word && at_where()) part_ = Part::clause;
    const bool outside = parens_ == 0;
    if (token.is("(")) ++parens_;
    if (token.is(")")) parens_ = std::max(0, parens_ - 1);
    if (part_ == Part::head && outside && (token.is("@") || is_one_of(token, {"if", "after"})))
      part_ = Part::clause;
    if (outside && token.is("->") && part_ != Part::option) {
      part_ = Part::word;
      return;
    }
    const bool modules = part_ == Part::head || part_ == Part::word;
    if (!modules || parens_ > (token.is("(") ? 1 : 0)) return;
    if (token.is("<") || token.is(">")) return;
    marks_[at_].module = true;
    if (part_ == Part::head) return;
    brackets_ += token.is("[") ? 1 : token.is("]") ? -1 : 0;
    polygons_ += token.is("{") ? 1 : token.is("}") ? -1 : 0;
    brackets_ = std::max(brackets_, 0);
  }

  const std::vector<Token>& tokens_;
  std::vector<LSystemToken> marks_;
  size_t at_ = 0;
  int blocks_ = 0, brackets_ = 0, polygons_ = 0, parens_ = 0;
  Part part_ = Part::fresh;
  bool fresh_ = true;
  bool listing_ = false;
};

}  // namespace

std::vector<LSystemToken> mark_lsystems(const std::vector<Token>& tokens) {
  return Marker(tokens).run();
}

}  // namespace vug::scene
