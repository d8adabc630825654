#include <vug/scene/grammar_parser.h>
#include <vug/scene/statement_parser.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

class StatementParser {
 public:
  StatementParser(Cursor& cursor, Document& document, const Includer& include)
      : cursor_(cursor), exprs_(cursor), document_(document), include_(include) {}

  void run() {
    for (;;) {
      while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
      if (cursor_.at_end()) return;
      try {
        statement();
        if (!cursor_.at_end() && cursor_.peek().kind != TokenKind::newline &&
            !cursor_.at_statement())
          cursor_.unexpected("the end of the line");
      } catch (const SyntaxFault&) {
        cursor_.recover_statement();
      }
    }
  }

 private:
  void statement() {
    const Token& word = cursor_.peek();
    if (word.is("}")) cursor_.fail(word, "a '}' without its '{'");
    cursor_.expect_name("a statement");
    if (word.text == "seed") return seed(word);
    if (word.text == "param") return param();
    if (word.text == "let") return let();
    if (word.text == "include") return include();
    if (word.text == "grammar") {
      document_.grammars.push_back(GrammarParser(cursor_).parse());
      return;
    }
    declaration(word);
  }

  void seed(const Token& word) {
    not_assigned("seed 7");
    ExprPtr value = exprs_.whole();
    if (document_.seed)
      cursor_.error(word, "a second seed",
                    fmt::format("the first is at {}", to_string(document_.seed->where)));
    else
      document_.seed = std::move(value);
  }

  void not_assigned(const char* example) {
    if (cursor_.peek().is("="))
      cursor_.fail(cursor_.peek(), "expected a value, found '='",
                   fmt::format("write it without '=': {}", example));
  }

  /// `NAME =`, with the value to follow.
  const Token& assigned(const char* what) {
    const Token& name = cursor_.expect_name(fmt::format("the name of the {}", what));
    cursor_.expect("=", fmt::format(" after '{}'", name.text));
    cursor_.skip_newlines();
    return name;
  }

  void param() {
    Param param;
    const Token& name = assigned("parameter");
    param.name = std::string(name.text);
    param.where = cursor_.where(name);
    param.value = exprs_.whole();
    if (cursor_.beyond_newlines().is_name("in")) {
      cursor_.skip_newlines();
      cursor_.take();
      exprs_.bounds(param.low, param.high);
    }
    if (cursor_.beyond_newlines().kind == TokenKind::text) {
      cursor_.skip_newlines();
      param.doc = unquote(cursor_.take().text);
    }
    document_.params.push_back(std::move(param));
  }

  void let() {
    Let let;
    const Token& name = assigned("let");
    let.name = std::string(name.text);
    let.where = cursor_.where(name);
    let.value = exprs_.whole();
    document_.lets.push_back(std::move(let));
  }

  void include() {
    const Token& path = cursor_.peek();
    if (path.kind != TokenKind::text) cursor_.unexpected("the path of a file in quotes");
    cursor_.take();
    include_(unquote(path.text), cursor_.where(path));
  }

  void declaration(const Token& kind) {
    const Token& name = cursor_.peek();
    if (name.is("="))
      cursor_.fail(kind, fmt::format("expected a statement, found '{} ='", kind.text),
                   fmt::format("write 'let {0} = ...' or 'param {0} = ...'", kind.text));
    if (name.is("{"))
      cursor_.fail(name, fmt::format("a declaration of kind '{}' without a name", kind.text),
                   fmt::format("write '{} main {{ ... }}'", kind.text));
    if (name.kind != TokenKind::name)
      cursor_.fail(
          kind, fmt::format("'{}' starts no statement", kind.text),
          suggestion(std::string(kind.text), {"seed", "param", "let", "include", "grammar"}));
    cursor_.take();
    Declaration made;
    made.kind = std::string(kind.text);
    made.kind_where = cursor_.where(kind);
    made.name = std::string(name.text);
    made.where = cursor_.where(name);
    if (cursor_.accept("=")) {
      cursor_.skip_newlines();
      made.value = exprs_.whole();
    } else {
      if (cursor_.beyond_newlines().is_name("on")) {
        cursor_.skip_newlines();
        cursor_.take();
        made.target = exprs_.whole();
      }
      if (!cursor_.accept_beyond_newlines("{")) {
        const std::string hint =
            nearest_name(made.kind, {"seed", "param", "let", "include", "grammar"});
        if (hint.empty()) cursor_.unexpected("'=' or '{'");
        cursor_.fail(kind, fmt::format("'{}' starts no statement", kind.text),
                     fmt::format("did you mean '{}'?", hint));
      }
      entries(made);
    }
    document_.declarations.push_back(std::move(made));
  }

  void entries(Declaration& made) {
    const Token& open = cursor_.last();
    for (;;) {
      while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
      if (cursor_.accept("}")) return;
      if (cursor_.at_end() || cursor_.at_statement()) {
        cursor_.error(open,
                      fmt::format("the '{{' of {} '{}' is never closed", made.kind, made.name));
        return;
      }
      try {
        made.entries.push_back(parse_entry(cursor_, exprs_));
        if (!cursor_.at_line_end() && cursor_.peek().kind != TokenKind::name)
          cursor_.unexpected("',', a name or the end of the line");
        misplaced_unit();
      } catch (const SyntaxFault&) {
        cursor_.recover_entry();
      }
    }
  }

  /// `spacing 2 cm` would make `cm` the next entry.
  void misplaced_unit() {
    const Token& next = cursor_.peek();
    if (cursor_.last().kind == TokenKind::number && is_unit(next.text) && next.text != "in")
      cursor_.unexpected("',', a name or the end of the line");
  }

  Cursor& cursor_;
  ExprParser exprs_;
  Document& document_;
  const Includer& include_;
};

}  // namespace

void parse_statements(Cursor& cursor, Document& document, const Includer& include) {
  StatementParser(cursor, document, include).run();
}

}  // namespace vug::scene
