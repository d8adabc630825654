// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/grammar_parser.h>
#include <vug/scene/statement_parser.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

namespace vug::scene {

namespace {

const std::vector<std::string> kWords = {"seed",    "param",   "let",    "def",
                                         "include", "grammar", "variant"};

class StatementParser {
 public:
  StatementParser(Cursor& cursor, Document& document, const Includer& include)
      : cursor_(cursor),
        exprs_(cursor),
        lookahead_(cursor),
        document_(document),
        include_(include) {}

  void run() {
    for (;;) {
      while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
      if (cursor_.at_end()) return;
      const size_t start = cursor_.position();
      const int faults = cursor_.faults();
      const Counts before = counts();
      const Token& first = cursor_.peek();
      try {
        statement();
        if (!cursor_.at_end() && cursor_.peek().kind != TokenKind::newline &&
            !cursor_.at_statement())
          cursor_.unexpected("the end of the line");
      } catch (const SyntaxFault&) {
        cursor_.recover_statement(start);
      }
      set_extents(before, cursor_.since(first));
      if (cursor_.faults() != faults) lose(before, start, first.is_name("include"));
    }
  }

 private:
  struct Counts {
    size_t params, lets, defs, declarations, grammars;
  };
  Counts counts() const {
    return {document_.params.size(), document_.lets.size(), document_.defs.size(),
            document_.declarations.size(), document_.grammars.size()};
  }

  static ExprPtr broken(const SourceLocation& where) {
    Expr expr;
    expr.kind = ExprKind::broken;
    expr.extent = expr.where = where;
    return std::make_shared<const Expr>(std::move(expr));
  }

  /// Sets the extent of the statement that was added since `before`; those of an included file,
  /// whose text was parsed by another parser, have theirs.
  void set_extents(const Counts& before, const SourceLocation& extent) {
    const auto set = [&](auto& all, size_t first) {
      for (size_t i = first; i < all.size(); ++i)
        if (!all[i].extent.known()) all[i].extent = extent;
    };
    set(document_.params, before.params);
    set(document_.lets, before.lets);
    set(document_.defs, before.defs);
    set(document_.declarations, before.declarations);
    set(document_.grammars, before.grammars);
  }

  /// After an error: stores the names in the statement that started at `start`.
  void lose(const Counts& before, size_t start, bool includes) {
    SkippedNames& skipped = document_.skipped;
    cursor_.add_names_since(start, skipped.mentioned);
    if (includes) {
      skipped.file = true;
      return;
    }
    const Counts now = counts();
    for (size_t i = before.params; i < now.params; ++i) {
      Param& param = document_.params[i];
      param.value = broken(param.where);
      param.low = param.high = nullptr;
    }
    for (size_t i = before.lets; i < now.lets; ++i)
      document_.lets[i].value = broken(document_.lets[i].where);
    for (size_t i = before.defs; i < now.defs; ++i) {
      document_.defs[i].body = broken(document_.defs[i].where);
      document_.defs[i].broken = true;
    }
    for (size_t i = before.declarations; i < now.declarations; ++i) {
      Declaration& made = document_.declarations[i];
      made.broken = made.broken || made.value;
      made.incomplete = true;
    }
    for (size_t i = before.grammars; i < now.grammars; ++i) document_.grammars[i].broken = true;
    const bool named =
        now.params + now.lets + now.defs + now.declarations + now.grammars >
        before.params + before.lets + before.defs + before.declarations + before.grammars;
    if (!named) cursor_.add_names_since(start, skipped.declared);
  }

  void statement() {
    const Token& word = cursor_.peek();
    if (word.is("}")) cursor_.fail(word, "a '}' without a matching '{'");
    cursor_.expect_name("a statement");
    if (word.text == "seed") return seed(word);
    if (word.text == "param") return param();
    if (word.text == "let") return let();
    if (word.text == "def") return def();
    if (word.text == "include") return include();
    if (word.text == "grammar") {
      const Token& name = cursor_.expect_name("the grammar's name");
      document_.grammars.emplace_back();
      document_.grammars.back().name = cursor_.declared_name(name);
      document_.grammars.back().where = cursor_.where(name);
      GrammarParser(cursor_).parse(document_.grammars.back(), lookahead_);
      return;
    }
    declaration(word);
  }

  void seed(const Token& word) {
    not_assigned("seed 7");
    ExprPtr value = exprs_.whole();
    if (document_.seed)
      cursor_.error(word, "duplicate seed",
                    fmt::format("the first is at {}", to_string(document_.seed->where)));
    else
      document_.seed = std::move(value);
  }

  void not_assigned(const char* example) {
    if (cursor_.peek().is("="))
      cursor_.fail(cursor_.peek(), "expected a value, found '='",
                   fmt::format("write it without '=': {}", example));
  }

  /// Parses `= value` after the name. The statement is already in the document, so an erroneous one
  /// has a name, too.
  ExprPtr assigned(const std::string& name) {
    if (!cursor_.accept_beyond_newlines("="))
      cursor_.unexpected(fmt::format("'=' after '{}'", name));
    cursor_.skip_newlines();
    return exprs_.whole();
  }

  void param() {
    const Token& name = cursor_.expect_name("the name of the parameter");
    Param& param = document_.params.emplace_back();
    param.name = cursor_.declared_name(name);
    param.where = cursor_.where(name);
    param.value = assigned(param.name);
    if (cursor_.beyond_newlines().is_name("in")) {
      cursor_.skip_newlines();
      cursor_.take();
      exprs_.bounds(param.low, param.high);
    }
    if (cursor_.beyond_newlines().kind == TokenKind::text) {
      cursor_.skip_newlines();
      param.doc = unquote(cursor_.take().text);
    }
  }

  void let() {
    const Token& name = cursor_.expect_name("the name of the let");
    Let& let = document_.lets.emplace_back();
    let.name = cursor_.declared_name(name);
    let.where = cursor_.where(name);
    let.value = assigned(let.name);
  }

  void def() {
    const Token& name = cursor_.expect_name("the name of the function");
    Def& def = document_.defs.emplace_back();
    def.name = cursor_.declared_name(name);
    def.where = cursor_.where(name);
    {
      cursor_.expect("(", fmt::format(" and the parameters after '{}'", def.name));
      const Cursor::BracketScope brackets(cursor_);
      def.formals = exprs_.formals();
    }
    if (cursor_.beyond_newlines().kind == TokenKind::text) {
      cursor_.skip_newlines();
      def.doc = unquote(cursor_.take().text);
    }
    if (!cursor_.accept_beyond_newlines("="))
      cursor_.unexpected(fmt::format("'=' and the value of '{}'", def.name));
    cursor_.skip_newlines();
    def.body = exprs_.whole();
    def.locals = exprs_.locals();
  }

  void include() {
    const Token& path = cursor_.peek();
    if (path.kind != TokenKind::text) cursor_.unexpected("the path of a file in quotes");
    cursor_.take();
    Include include;
    include.path = unquote(path.text);
    include.where = cursor_.where(path);
    if (cursor_.peek().is_name("as")) {
      cursor_.take();
      const Token& name = cursor_.expect_name("the name of the module after 'as'");
      include.name = cursor_.declared_name(name);
      include.name_where = cursor_.where(name);
    }
    if (cursor_.beyond_newlines().is("{")) {
      if (include.name.empty())
        cursor_.fail(cursor_.beyond_newlines(), "only a module can be given parameters",
                     "include \"file.vug\" as NAME { PARAMETER VALUE }");
      cursor_.accept_beyond_newlines("{");
      Declaration values;  // only its entries
      values.kind = "include";
      values.name = include.name;
      entries(values);
      include.entries = std::move(values.entries);
    }
    include_(include);
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
      cursor_.fail(kind, fmt::format("unknown statement '{}'", kind.text),
                   suggestion(std::string(kind.text), kWords));
    cursor_.take();
    const int faults = cursor_.faults();
    Declaration& made = document_.declarations.emplace_back();
    made.broken = true;  // until it is parsed
    made.kind = std::string(kind.text);
    made.kind_where = cursor_.where(kind);
    made.name = cursor_.declared_name(name);
    made.where = cursor_.where(name);
    if (cursor_.peek().is("[") && cursor_.peek().touches) made.loop = exprs_.declared_loop();
    if (cursor_.accept_beyond_newlines("=")) {
      cursor_.skip_newlines();
      made.value = exprs_.whole();
    } else {
      if (cursor_.beyond_newlines().is_name("on")) {
        cursor_.skip_newlines();
        made.on_where = cursor_.where(cursor_.take());
        made.target = exprs_.whole();
        while (cursor_.accept(",")) {
          cursor_.skip_newlines();
          made.more_targets.push_back(exprs_.whole());
        }
      }
      if (!cursor_.accept_beyond_newlines("{")) {
        const std::string hint = did_you_mean(made.kind, kWords);
        if (hint.empty()) cursor_.unexpected("'=' or '{'");
        cursor_.fail(kind, fmt::format("unknown statement '{}'", kind.text), hint);
      }
      if (cursor_.faults() == faults) made.broken = false;
      entries(made);
      return;
    }
    if (cursor_.faults() == faults) made.broken = false;
  }

  void entries(Declaration& made) {
    const Token& open = cursor_.last();
    for (;;) {
      while (cursor_.peek().kind == TokenKind::newline) cursor_.take();
      if (cursor_.accept("}")) return;
      if (cursor_.at_end() || cursor_.at_statement()) {
        made.incomplete = true;
        cursor_.error(open,
                      fmt::format("the '{{' of {} '{}' is never closed", made.kind, made.name));
        return;
      }
      const int faults = cursor_.faults();
      const size_t before = made.entries.size();
      const Token& key = cursor_.peek();
      try {
        made.entries.push_back(parse_entry(cursor_, exprs_));
        if (made.kind == "variant" && cursor_.module())  // it sets parameters of its own file
          made.entries.back().key.insert(0, *cursor_.module());
        reject_comma(made.entries.back());
        if (!cursor_.at_line_end() && cursor_.peek().kind != TokenKind::name)
          cursor_.unexpected("',', a name or the end of the line");
        misplaced_unit();
        if (made.kind == "render" && made.entries.back().key == "size") spaced_size();
      } catch (const SyntaxFault&) {
        cursor_.recover_entry();
      }
      if (cursor_.faults() == faults) continue;
      made.incomplete = true;
      if (made.entries.size() == before && key.kind == TokenKind::name)
        made.entries.push_back({std::string(key.text), cursor_.where(key), cursor_.since(key), {}});
      if (made.entries.size() > before) made.entries.back().values = {broken(cursor_.where(key))};
    }
  }

  /// Rejects `fov 60deg, aperture 2cm`, where `aperture` is a value of the entry `fov`.
  void reject_comma(const Entry& entry) {
    const Token& next = cursor_.peek();
    if (entry.values.size() < 2 || entry.values.back()->kind != ExprKind::name ||
        cursor_.at_line_end() || next.kind == TokenKind::name || !ExprParser::starts(next))
      return;
    const std::string name = entry.values.back()->text;
    cursor_.fail(
        next, fmt::format("expected ',', a name or the end of the line, found {}", describe(next)),
        fmt::format("separate entries by spaces: remove the ',' before '{}'", name));
  }

  /// Rejects `size 1920 x 1080`, where `x` would become the next entry.
  void spaced_size() {
    const Token& cross = cursor_.peek();
    if (cursor_.last().kind != TokenKind::number || cross.kind != TokenKind::name ||
        cross.text.find_first_not_of("0123456789", 1) != std::string_view::npos ||
        cross.text[0] != 'x')
      return;
    const Token& height = cursor_.peek(1);
    const std::string_view digits = cross.text.size() > 1              ? cross.text.substr(1)
                                    : height.kind == TokenKind::number ? height.text
                                                                       : std::string_view("1080");
    cursor_.fail(
        cross,
        fmt::format("expected ',', a name or the end of the line, found {}", describe(cross)),
        fmt::format("write the size without spaces: {}x{}", cursor_.last().text, digits));
  }

  /// Rejects `spacing 2 cm`, where `cm` would become the next entry.
  void misplaced_unit() {
    const Token& next = cursor_.peek();
    if (cursor_.last().kind == TokenKind::number && is_unit(next.text) && next.text != "in")
      cursor_.unexpected("',', a name or the end of the line");
  }

  Cursor& cursor_;
  ExprParser exprs_;
  RuleLookahead lookahead_;
  Document& document_;
  const Includer& include_;
};

}  // namespace

void parse_statements(Cursor& cursor, Document& document, const Includer& include) {
  StatementParser(cursor, document, include).run();
}

}  // namespace vug::scene
