// SPDX-License-Identifier: Apache-2.0
#include <vug/language/describe.h>
#include <vug/loading/catalogue.h>
#include <vug/scene/text_at.h>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace vug::language {
namespace {

/// Maximum number of lines of a declaration in a description.
constexpr int kMaxLines = 8;

std::string source_of(const std::string& cite) {
  return cite.empty() ? "" : fmt::format("\n\nSource: {}", cite);
}

/// The comment lines directly above a line of a text.
std::string comment_above(const std::string& text, int line) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string each; static_cast<int>(lines.size()) + 1 < line && std::getline(in, each);)
    lines.push_back(each);
  std::string comment;
  while (!lines.empty() && lines.back().starts_with("#")) {
    comment =
        lines.back().substr(std::min(lines.back().find_first_not_of("# "), lines.back().size())) +
        (comment.empty() ? "" : " ") + comment;
    lines.pop_back();
  }
  return comment;
}

std::string first_lines(std::string_view text) {
  int lines = 0;
  for (size_t at = 0; at < text.size(); ++at)
    if (text[at] == '\n' && ++lines == kMaxLines) return std::string(text.substr(0, at)) + "\n...";
  return std::string(text);
}

}  // namespace

std::string code_block(const std::string& text) { return fmt::format("```vug\n{}\n```", text); }

std::string signature_text(const CallMeaning& meaning) {
  std::string text = meaning.info.name + "(";
  bool first = true;
  for (const ParamInfo& param : meaning.info.params) {
    if (param.name.empty()) continue;
    const std::string type = param.type.empty() ? "" : ": " + param.type;
    text += first ? "" : ", ";
    text += param.required ? param.name + type : fmt::format("[{}{}]", param.name, type);
    first = false;
  }
  text += ")";
  return meaning.type.empty() ? text : text + " -> " + meaning.type;
}

std::string describe(const CallMeaning& meaning) {
  return code_block(signature_text(meaning)) +
         (meaning.info.doc.empty() ? "" : "\n" + meaning.info.doc) + source_of(meaning.info.cite);
}

std::string describe(const ParamInfo& param) {
  const std::string type = param.type.empty() ? "" : loading::describe(param);
  return fmt::format("**{}**{}{}{}{}", param.name, type.empty() ? "" : ": ", type,
                     param.doc.empty() ? "" : "\n\n", param.doc);
}

std::string describe(const Symbol& symbol, const scene::Document& document) {
  std::string text, doc = symbol.doc;
  for (const auto& source : document.sources) {
    if (source->file != symbol.where.file) continue;
    text = first_lines(scene::text_at(source->text, symbol.extent));
    if (doc.empty() && symbol.scope.known() == false)
      doc = comment_above(source->text, symbol.extent.line);
    break;
  }
  if (symbol.scope.known() && symbol.kind != SymbolKind::rule && symbol.kind != SymbolKind::table)
    text = symbol.name;
  return fmt::format("{} `{}`\n{}{}{}", description(symbol), symbol.full_name, code_block(text),
                     doc.empty() ? "" : "\n", doc);
}

std::string describe(const LanguageWord& word) { return code_block(word.use) + "\n" + word.doc; }

std::string describe(const KindInfo& declaration) {
  return fmt::format("**{}** {}{}", declaration.name, declaration.doc, source_of(declaration.cite));
}

}  // namespace vug::language
