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

void apply(const std::string& change, Recipe& recipe) {
  if (begins(change, kSeed)) {
    const std::string seed = change.substr(std::string(kSeed).size());
    if (!replace(recipe.scene, {"seed"}, seed)) recipe.scene += fmt::format("seed {}\n", seed);
    return;
  }
  if (begins(change, kDefine)) {
    const std::string given = change.substr(std::string(kDefine).size());
    const size_t equals = std::min(given.find('='), given.size());
    if (equals < given.size() &&
        replace(recipe.scene, {"param", given.substr(0, equals), "="}, given.substr(equals + 1)))
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
