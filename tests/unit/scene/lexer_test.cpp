// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/scene/lexer.h>

namespace vug::scene {
namespace {

std::string kinds(const std::string& text) {
  Diagnostics diagnostics;
  std::string out;
  for (const Token& token : lex(text, "t", diagnostics)) {
    if (token.kind == TokenKind::end) break;
    if (!out.empty()) out += " ";
    switch (token.kind) {
      case TokenKind::newline:
        out += "nl";
        break;
      case TokenKind::number:
        out += "num:";
        break;
      case TokenKind::size:
        out += "size:";
        break;
      case TokenKind::text:
        out += "text:";
        break;
      case TokenKind::name:
        out += "name:";
        break;
      case TokenKind::junk:
        out += "junk";
        break;
      default:
        break;
    }
    if (token.kind != TokenKind::newline && token.kind != TokenKind::junk) out += token.text;
  }
  return out + (diagnostics.has_errors() ? " !" : "");
}

Number number_token(const std::string& text) {
  Diagnostics diagnostics;
  const auto tokens = lex(text, "t", diagnostics);
  EXPECT_EQ(tokens.size(), 2u) << text;
  EXPECT_FALSE(diagnostics.has_errors()) << text;
  return tokens[0].number;
}

TEST(Lexer, DistinguishesRangesFromNumbers) {
  EXPECT_EQ(kinds("1..32"), "num:1 .. num:32");
  EXPECT_EQ(kinds("0.6..1.2"), "num:0.6 .. num:1.2");
  EXPECT_EQ(kinds(".5...75"), "num:.5 .. num:.75");
  EXPECT_EQ(kinds("5.abs()"), "num:5 . name:abs ( )");
  EXPECT_EQ(kinds("0%..100%"), "num:0% .. num:100%");
}

TEST(Lexer, DistinguishesSizesUnitsAndExponents) {
  EXPECT_EQ(kinds("1920x1080"), "size:1920x1080");
  EXPECT_EQ(kinds("2xy"), "num:2xy !");
  EXPECT_EQ(kinds("1e-3 2e 3em"), "num:1e-3 num:2e num:3em !");
  EXPECT_EQ(kinds("10in 10 in"), "num:10in num:10 name:in");
}

TEST(Lexer, SignsMatchGreedily) {
  EXPECT_EQ(kinds("a->b"), "name:a -> name:b");
  EXPECT_EQ(kinds("a<=b>=c==d!=e"), "name:a <= name:b >= name:c == name:d != name:e");
  EXPECT_EQ(kinds("a - > b"), "name:a - > name:b");
}

TEST(Lexer, CommentsAndSemicolons) {
  EXPECT_EQ(kinds("a # b ; c\nd;e"), "name:a nl name:d nl name:e");
  EXPECT_EQ(kinds("\"# no comment\" # one"), "text:\"# no comment\"");
}

TEST(Lexer, UnitsAreExact) {
  EXPECT_EQ(number_token("52%").value, 0.52);
  EXPECT_EQ(number_token("30cm").value, 0.3);
  EXPECT_EQ(number_token("7mm").value, 0.007);
  EXPECT_EQ(number_token("1in").value, 0.0254);
  EXPECT_EQ(number_token("1ft").value, 0.3048);
  EXPECT_EQ(number_token("180deg").value, kPi);
  EXPECT_EQ(number_token("250ms").value, 0.25);
  EXPECT_EQ(number_token("2km").value, 2000);
  EXPECT_EQ(number_token("1e-400").value, 0);
  EXPECT_EQ(number_token("30deg").dimension, Dimension::angle);
  EXPECT_EQ(number_token("30").dimension, Dimension::none);
}

TEST(Lexer, ColumnsCountCharacters) {
  Diagnostics diagnostics;
  const std::string text = "\t\"h\xc3\xa4ng\" b\n  c";
  const auto tokens = lex(text, "t", diagnostics);
  EXPECT_EQ(tokens[0].column, 2);
  EXPECT_EQ(tokens[1].column, 9);
  EXPECT_EQ(tokens[3].line, 2);
  EXPECT_EQ(tokens[3].column, 3);
}

TEST(Lexer, OneDiagnosticPerRunOfInvalidCharacters) {
  Diagnostics diagnostics;
  const std::string text("a \x01\x02\x03 b \xff\xff", 10);
  lex(text, "t", diagnostics);
  EXPECT_EQ(diagnostics.all().size(), 2u);
}

TEST(Lexer, TextsKeepTheirContent) {
  EXPECT_EQ(unquote(R"("a \"b\" \\ \n")"), "a \"b\" \\ \n");
  EXPECT_EQ(unquote("\"open"), "open");
}

TEST(Lexer, LineEndsAndMarksAreNormalised) {
  EXPECT_EQ(normalise_text("\xef\xbb\xbf"
                           "a\r\nb\rc\n"),
            "a\nb\nc\n");
}

}  // namespace
}  // namespace vug::scene
