// SPDX-License-Identifier: Apache-2.0
// Inside the module: follows the tokens of a text up to a position.
#pragma once

#include <vug/language/context.h>

namespace vug::language {

class ContextScanner {
 public:
  explicit ContextScanner(const std::vector<scene::Token>& tokens) : tokens_(tokens) {}

  /// Reads the next token, which is not a comment.
  void read(size_t index);
  /// The context after the tokens that were read; `ahead` is the index of the next one.
  Context finish(size_t ahead) const;

 private:
  struct Frame {
    char open = '(';
    bool is_call = false;
    OpenCall call = {};
    bool binding = false;  ///< Between `for` and `in`, or in the parameters of a def or a rule.
    bool operand = false;  ///< The last token completed a value.
    std::string key = {};  ///< The entry of a block.
    bool at_key = true;    ///< In a block: a name is a key.
    bool symbols = false;  ///< In a block: after "->" or `axiom`.
    std::set<std::string> keys = {};
    std::string kind = {};
  };

  bool begins_statement(size_t index) const;
  void begin_statement();
  void end_line();
  void open(const scene::Token& token, size_t index);
  void close();
  void name(const scene::Token& token, size_t index);
  void statement_name(const scene::Token& token);
  void block_name(const scene::Token& token);
  void sign(const scene::Token& token, size_t index);
  Frame* frame() { return frames_.empty() ? nullptr : &frames_.back(); }
  void set_operand(bool complete);
  bool operand() const { return frames_.empty() ? operand_ : frames_.back().operand; }
  Place place() const;
  void fill_call(Context& context) const;
  void add_later_names(OpenCall& call, size_t ahead) const;

  const std::vector<scene::Token>& tokens_;
  std::vector<Frame> frames_;
  int words_ = 0;          ///< Tokens of the statement so far.
  bool assigned_ = false;  ///< After "=" of the statement.
  bool operand_ = false;
  bool ended_ = false;  ///< A line ended after a complete statement.
  bool colon_ = false;  ///< After "grammar NAME:".
  bool where_ = false;  ///< After `where`.
  int start_column_ = 1;
  size_t last_ = 0;  ///< Index of the last token.
  Context context_;
};

}  // namespace vug::language
