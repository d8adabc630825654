// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/delivery/describe_file.h>
#include <vug/delivery/recipe.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/lexer.h>
#include <vug/scene/parser.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <optional>

namespace vug::delivery {
namespace {

using scene::Token;
using scene::TokenKind;

constexpr const char* kDefine = "# -D ";
constexpr const char* kSeed = "# --seed ";
/// Settings that a scene text cannot contain.
constexpr const char* kArguments[] = {"# --frame ", "# --quality "};

bool begins(const std::string& line, const std::string& with) {
  return line.compare(0, with.size(), with) == 0;
}

bool records_change(const std::string& line) {
  return begins(line, kDefine) || begins(line, kSeed) ||
         std::any_of(std::begin(kArguments), std::end(kArguments),
                     [&](const char* each) { return begins(line, each); });
}

/// Removes and returns the lines at the end that record overrides.
std::vector<std::string> changes(std::string& text) {
  std::vector<std::string> out;
  while (!text.empty() && text.back() == '\n') {
    const size_t before = text.size() < 2 ? std::string::npos : text.rfind('\n', text.size() - 2);
    const size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::string line = text.substr(begin, text.size() - 1 - begin);
    if (!records_change(line)) break;
    out.insert(out.begin(), line);
    text.resize(begin);
  }
  return out;
}

/// A range of bytes in a text.
struct Span {
  size_t begin, end;
};

/// The expression that begins at token `from`. It ends before a newline, `in` or a string if the
/// text up to there parses as an expression.
std::optional<Span> expression(const std::string& text, const std::vector<Token>& tokens,
                               size_t from) {
  const auto begin_of = [&](size_t i) {
    return static_cast<size_t>(tokens[i].text.data() - text.data());
  };
  std::optional<Span> found;
  int depth = 0;
  for (size_t i = from; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.is("(") || token.is("[")) ++depth;
    if (token.is(")") || token.is("]")) --depth;
    const bool stops = token.kind == TokenKind::newline || token.kind == TokenKind::end ||
                       token.is_name("in") || token.kind == TokenKind::text;
    if (depth > 0 || i == from || !stops) continue;
    const Token& last = tokens[i - 1];
    const size_t begin = begin_of(from), end = begin_of(i - 1) + last.text.size();
    Diagnostics faults;
    if (last.kind != TokenKind::newline &&
        scene::parse_expression(text.substr(begin, end - begin), "", faults) &&
        !faults.has_errors())
      found = Span{begin, end};
    // A line that begins with an operator continues the previous one.
    size_t next = i;
    while (next < tokens.size() && tokens[next].kind == TokenKind::newline) ++next;
    if (token.kind != TokenKind::newline || next == tokens.size() ||
        tokens[next].kind != TokenKind::sign || tokens[next].is("}"))
      break;
  }
  return found;
}

/// Replaces the expression after the tokens `words` at the beginning of a statement by `value`.
bool replace(std::string& text, const std::vector<std::string>& words, const std::string& value) {
  Diagnostics ignored;
  const std::vector<Token> tokens = scene::lex(text, "", ignored);
  for (size_t i = 0; i + words.size() < tokens.size(); ++i) {
    if (i > 0 && tokens[i - 1].kind != TokenKind::newline) continue;
    bool same = true;
    for (size_t k = 0; k < words.size(); ++k) same = same && tokens[i + k].text == words[k];
    if (!same) continue;
    const std::optional<Span> span = expression(text, tokens, i + words.size());
    if (!span) return false;
    text.replace(span->begin, span->end - span->begin, value);
    return true;
  }
  return false;
}

size_t begin_of(const std::string& text, const Token& token) {
  return static_cast<size_t>(token.text.data() - text.data());
}

/// The number of tokens of the value that begins at token `from` of a block: the most tokens that
/// form an expression, up to the end of the line or of the block; 0 if there are none.
size_t value_length(const std::string& text, const std::vector<Token>& tokens, size_t from) {
  size_t length = 0;
  int depth = 0;
  for (size_t i = from; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (depth == 0 && (token.kind == TokenKind::newline || token.is("}"))) break;
    if (token.kind == TokenKind::end) break;
    if (token.is("(") || token.is("[")) ++depth;
    if (token.is(")") || token.is("]")) --depth;
    const size_t begin = begin_of(text, tokens[from]);
    Diagnostics faults;
    if (depth == 0 &&
        scene::parse_expression(
            text.substr(begin, begin_of(text, token) + token.text.size() - begin), "", faults))
      length = i + 1 - from;
  }
  return length;
}

/// Sets a parameter in the block whose '{' is token `brace`, to which it is added if it is missing.
bool set_in_block(std::string& text, const std::vector<Token>& tokens, size_t brace,
                  const std::string& parameter, const std::string& value) {
  for (size_t i = brace + 1; i + 1 < tokens.size() && !tokens[i].is("}");) {
    if (tokens[i].kind == TokenKind::newline) {
      ++i;
      continue;
    }
    const size_t length = value_length(text, tokens, i + 1);
    if (length == 0) return false;
    const Token& last = tokens[i + length];
    if (tokens[i].text == parameter) {
      const size_t begin = begin_of(text, tokens[i + 1]);
      text.replace(begin, begin_of(text, last) + last.text.size() - begin, value);
      return true;
    }
    i += 1 + length;
  }
  text.insert(begin_of(text, tokens[brace]) + 1, fmt::format(" {} {} ", parameter, value));
  return true;
}

/// Sets the parameter `name`, "MODULE.PARAMETER", in `include "..." as MODULE`.
bool set_in_module(std::string& text, const std::string& name, const std::string& value) {
  const size_t dot = name.find('.');
  if (dot == std::string::npos) return false;
  const std::string module = name.substr(0, dot), parameter = name.substr(dot + 1);
  Diagnostics ignored;
  const std::vector<Token> tokens = scene::lex(text, "", ignored);
  for (size_t i = 0; i + 4 < tokens.size(); ++i) {
    const bool first = i == 0 || tokens[i - 1].kind == TokenKind::newline;
    if (!first || !tokens[i].is_name("include") || !tokens[i + 2].is_name("as") ||
        tokens[i + 3].text != module)
      continue;
    size_t next = i + 4;
    while (tokens[next].kind == TokenKind::newline && tokens[next].text != ";") ++next;
    if (tokens[next].is("{")) return set_in_block(text, tokens, next, parameter, value);
    text.insert(begin_of(text, tokens[i + 3]) + module.size(),
                fmt::format(" {{ {} {} }}", parameter, value));
    return true;
  }
  return false;
}

void apply(const std::string& change, Recipe& recipe) {
  if (begins(change, kSeed)) {
    const std::string seed = change.substr(std::string(kSeed).size());
    if (!replace(recipe.scene, {"seed"}, seed)) recipe.scene += fmt::format("seed {}\n", seed);
    return;
  }
  if (begins(change, kDefine)) {
    const std::string given = change.substr(std::string(kDefine).size());
    const size_t equals = std::min(given.find('='), given.size());
    const std::string name = given.substr(0, equals);
    if (equals < given.size() &&
        (replace(recipe.scene, {"param", name, "="}, given.substr(equals + 1)) ||
         set_in_module(recipe.scene, name, given.substr(equals + 1))))
      return;
  }
  recipe.arguments.push_back(change.substr(2));
}

}  // namespace

Recipe parse_recipe(const std::string& kept) {
  Recipe recipe;
  recipe.scene = scene::normalise_text(kept);
  for (const std::string& change : changes(recipe.scene)) apply(change, recipe);
  return recipe;
}

Recipe read_recipe(const std::filesystem::path& file) {
  const nlohmann::ordered_json about = describe_file(file);
  const auto metadata = about.find("metadata");
  const auto text = [&](const char* name) -> std::string {
    if (metadata == about.end() || !metadata->is_object()) return {};
    const auto found = metadata->find(name);
    return found != metadata->end() && found->is_string() ? found->get<std::string>() : "";
  };
  const std::string kept = text("vug:recipe");
  if (kept.empty())
    throw Error(ErrorCode::bad_input, fmt::format("'{}' contains no recipe", file.string()), {},
                "files of vug build, export and render contain one");
  Recipe recipe = parse_recipe(kept);
  recipe.version = text("vug:version");
  return recipe;
}

}  // namespace vug::delivery
