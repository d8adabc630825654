// SPDX-License-Identifier: Apache-2.0
#include <vug/language/context_scanner.h>
#include <vug/language/kinds.h>
#include <vug/language/words.h>

#include <utility>

namespace vug::language {
namespace {

using scene::Token;
using scene::TokenKind;

bool is_line_break(const Token& token) { return token.kind == TokenKind::newline; }

/// Words between two operands.
bool joins(const Token& token) {
  return token.is_name("and") || token.is_name("or") || token.is_name("in") ||
         token.is_name("on") || token.is_name("where") || token.is_name("if") ||
         token.is_name("for") || token.is_name("sort") || token.is_name("by") ||
         token.is_name("as") || token.is_name("not");
}

bool is_keyword(const std::string& word) {
  return find_word(statement_words(), word) || find_declaration(word);
}

}  // namespace

/// Whether a line begins a statement even if brackets are open: at the margin, a keyword and a
/// name.
bool ContextScanner::begins_statement(size_t index) const {
  const Token& token = tokens_[index];
  const bool first = index == 0 || is_line_break(tokens_[index - 1]) ||
                     tokens_[index - 1].kind == TokenKind::comment;
  if (!first || token.kind != TokenKind::name || token.column > start_column_ ||
      index + 1 >= tokens_.size() || !is_keyword(std::string(token.text)))
    return false;
  const Token& next = tokens_[index + 1];
  return next.kind == TokenKind::name || next.kind == TokenKind::text ||
         (token.is_name("seed") && next.kind == TokenKind::number);
}

void ContextScanner::begin_statement() {
  frames_.clear();
  words_ = 0;
  assigned_ = operand_ = ended_ = colon_ = where_ = false;
  context_ = Context();
}

void ContextScanner::set_operand(bool complete) {
  (frames_.empty() ? operand_ : frames_.back().operand) = complete;
  if (Frame* top = frame(); top && top->is_call) top->call.begins = false;
}

void ContextScanner::end_line() {
  if (frames_.empty()) {
    ended_ = words_ > 0 && (operand_ || words_ < 2);
    return;
  }
  Frame& top = frames_.back();
  if (top.open != '{') return;
  if (!top.key.empty() && top.operand) {
    top.keys.insert(top.key);
    top.key.clear();
  }
  if (top.operand || top.symbols) {
    top.at_key = true;
    top.symbols = top.operand = false;
  }
}

void ContextScanner::read(size_t index) {
  const Token& token = tokens_[index];
  if (begins_statement(index)) begin_statement();
  if (is_line_break(token)) {
    if (token.text == ";" && frames_.empty())
      begin_statement();
    else
      end_line();
    last_ = index;
    return;
  }
  if (frames_.empty() && ended_) {
    const bool goes_on = token.is("=") || token.is("{") || token.is(".") || token.is("->") ||
                         joins(token) || token.kind == TokenKind::text ||
                         (token.kind == TokenKind::sign && !token.is("}"));
    if (!goes_on) begin_statement();
    ended_ = false;
  }
  if (frames_.empty() && words_ == 0) start_column_ = token.column;
  switch (token.kind) {
    case TokenKind::name:
      name(token, index);
      break;
    case TokenKind::sign:
      sign(token, index);
      break;
    default:
      set_operand(true);
  }
  if (frames_.empty()) ++words_;
  last_ = index;
}

void ContextScanner::name(const Token& token, size_t index) {
  if (where_ && index + 1 < tokens_.size() && tokens_[index + 1].is("="))
    context_.locals.emplace(token.text);
  if (token.is_name("where")) where_ = true;
  Frame* top = frame();
  if (!top) return statement_name(token);
  if (top->open == '[' && token.is_name("for")) top->binding = true;
  if (top->binding && token.is_name("in")) top->binding = false;
  if (top->binding && !token.is_name("for")) context_.locals.emplace(token.text);
  if (top->open == '{') return block_name(token);
  set_operand(!joins(token));
}

void ContextScanner::statement_name(const Token& token) {
  const std::string word(token.text);
  if (words_ == 0) {
    context_.keyword = word;
    operand_ = false;
  } else if ((words_ == 1 && !assigned_) || tokens_[last_].is_name("as")) {
    context_.name = word;
    if (context_.keyword == "grammar") context_.grammar = "shape";
    operand_ = true;
  } else if (colon_) {
    context_.grammar = word;
    colon_ = false;
    operand_ = true;
  } else if (!assigned_ && token.is_name("on")) {
    context_.target = true;
    operand_ = false;
  } else {
    operand_ = !joins(token);
  }
}

void ContextScanner::block_name(const Token& token) {
  Frame& top = frames_.back();
  const bool member = last_ < tokens_.size() && tokens_[last_].is(".") && !top.at_key;
  if (top.symbols || member) {
    top.operand = !joins(token);
    return;
  }
  if (top.at_key || (top.operand && !joins(token))) {
    if (!top.key.empty()) top.keys.insert(top.key);
    top.key = std::string(token.text);
    top.at_key = top.operand = false;
    top.symbols = top.key == "axiom" && !context_.grammar.empty();
    return;
  }
  if (top.key == "kind" && top.kind.empty()) top.kind = std::string(token.text);
  top.operand = !joins(token);
}

void ContextScanner::open(const Token& token, size_t index) {
  Frame made;
  made.open = token.text[0];
  const Token* before = index > 0 ? &tokens_[index - 1] : nullptr;
  if (made.open == '(' && token.touches && before && before->kind == TokenKind::name) {
    made.is_call = true;
    made.call.name = std::string(before->text);
    made.call.method = index >= 2 && tokens_[index - 2].is(".");
    if (made.call.method && index >= 3 && tokens_[index - 3].kind == TokenKind::name)
      made.call.receiver = std::string(tokens_[index - 3].text);
    made.call.position = made.call.unnamed = made.call.method ? 1 : 0;
    made.call.begins = true;
    const bool def = frames_.empty() && context_.keyword == "def" && words_ == 2;
    const bool head = !frames_.empty() && frames_.back().open == '{' && !context_.grammar.empty() &&
                      !frames_.back().symbols;
    made.binding = def || head;
  }
  frames_.push_back(std::move(made));
}

void ContextScanner::close() {
  if (frames_.empty()) return;
  frames_.pop_back();
  set_operand(true);
}

void ContextScanner::sign(const Token& token, size_t index) {
  const bool lsystem = context_.grammar == "lsystem" && !frames_.empty() &&
                       frames_.back().open == '{' && frames_.back().symbols;
  if (lsystem && !token.is("(") && !token.is("}") && !token.is("->")) return;  // a module
  if (token.is("(") || token.is("[") || token.is("{")) return open(token, index);
  if (token.is(")") || token.is("]")) {
    if (!frames_.empty() && frames_.back().open != '{') close();
    return;
  }
  Frame* top = frame();
  if (token.is("}")) {
    while (!frames_.empty() && frames_.back().open != '{') frames_.pop_back();
    close();
    if (frames_.empty()) ended_ = operand_ = true;
    return;
  }
  if (!top) {
    if (token.is("=")) assigned_ = true;
    colon_ = token.is(":") && context_.keyword == "grammar";
    operand_ = false;
    return;
  }
  if (top->open == '{') {
    if (token.is("->")) {
      top->symbols = true;
      top->at_key = false;
      if (!top->key.empty()) top->keys.insert(std::exchange(top->key, ""));
    }
    top->operand = false;
    return;
  }
  if (top->is_call) {
    if (token.is(",")) {
      if (top->call.argument.empty()) ++top->call.unnamed;
      ++top->call.position;
      top->call.argument.clear();
      top->call.begins = true;
      top->operand = false;
      return;
    }
    if (token.is(":") && top->call.argument.empty() && index > 0 &&
        tokens_[index - 1].kind == TokenKind::name) {
      top->call.argument = std::string(tokens_[index - 1].text);
      top->call.given.insert(top->call.argument);
    }
  }
  set_operand(false);
}

Place ContextScanner::place() const {
  if (!tokens_.empty() && last_ < tokens_.size() && tokens_[last_].is(".")) return Place::member;
  if (frames_.empty()) {
    if (words_ == 0 || ended_) return Place::statement;
    if (context_.keyword == "include") return words_ == 1 ? Place::path : Place::after_value;
    if (context_.keyword == "seed") return Place::value;
    if (words_ == 1) return Place::new_name;
    if (colon_) return Place::grammar_kind;
    if (operand_) return Place::after_value;
    return Place::value;
  }
  const Frame& top = frames_.back();
  if (top.binding) return Place::new_name;
  if (top.open == '{') {
    if (top.symbols) return Place::symbols;
    if (top.at_key || top.operand) return Place::key;
  }
  return top.operand ? Place::after_value : Place::value;
}

void ContextScanner::add_later_names(OpenCall& call, size_t ahead) const {
  int depth = 0;
  for (size_t i = ahead; i < tokens_.size() && depth >= 0; ++i) {
    const Token& token = tokens_[i];
    if (begins_statement(i)) return;
    if (token.is("(") || token.is("[") || token.is("{")) ++depth;
    if (token.is(")") || token.is("]") || token.is("}")) --depth;
    if (depth == 0 && token.is(":") && i > ahead && tokens_[i - 1].kind == TokenKind::name)
      call.given.emplace(tokens_[i - 1].text);
  }
}

Context ContextScanner::finish(size_t ahead) const {
  Context context = context_;
  context.place = place();
  if (context.place == Place::member && last_ > 0 && tokens_[last_ - 1].kind == TokenKind::name)
    context.receiver = std::string(tokens_[last_ - 1].text);
  for (const Frame& each : frames_) {
    if (each.open == '{') {
      context.in_block = true;
      context.key = each.key;
      context.keys = each.keys;
      if (each.operand && !each.key.empty()) context.keys.insert(each.key);
      context.kind = each.kind;
      context.calls.clear();
      context.in_list = context.in_vector = false;
    } else if (each.is_call) {
      context.calls.push_back(each.call);
      context.in_list = context.in_vector = false;
    } else {
      (each.open == '[' ? context.in_list : context.in_vector) = true;
    }
  }
  if (!context.calls.empty() && frames_.back().is_call)
    add_later_names(context.calls.back(), ahead);
  return context;
}

}  // namespace vug::language
