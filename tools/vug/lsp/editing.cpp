// SPDX-License-Identifier: Apache-2.0
// Answers that help to write: completion, hover, signatures, formatting, code actions, colours.
#include "lsp/convert.h"
#include "lsp/server.h"

#include <vug/language/colours.h>
#include <vug/language/fixes.h>
#include <vug/language/hover.h>
#include <vug/language/signature.h>
#include <vug/scene/format.h>

#include <algorithm>
#include <sstream>

namespace vug::lsp {
namespace {

using language::AnalysisPtr;

Json completion(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  return to_json(
      language::complete(session.documents.workspace(), *text, session.position(*text, params)),
      session.documents, session.snippets);
}

Json hover(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const auto found = language::hover_at(*text, session.position(*text, params));
  if (!found) return nullptr;
  return {{"contents", markdown(found->text)}, {"range", session.documents.range(found->range)}};
}

Json signature_help(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const auto all = language::signatures_at(*text, session.position(*text, params));
  if (all.empty()) return nullptr;
  const TextIndex& units = session.documents.index(text->file);
  Json signatures = Json::array();
  for (const language::Signature& each : all) {
    Json parameters = Json::array();
    for (const auto& parameter : each.parameters)
      parameters.push_back({{"label",
                             {units.units(each.label.substr(0, parameter.begin)),
                              units.units(each.label.substr(0, parameter.end))}},
                            {"documentation", markdown(parameter.doc)}});
    Json signature = {{"label", each.label},
                      {"documentation", markdown(each.doc)},
                      {"parameters", std::move(parameters)}};
    if (each.active >= 0) signature["activeParameter"] = each.active;
    signatures.push_back(std::move(signature));
  }
  return {{"signatures", std::move(signatures)},
          {"activeSignature", 0},
          {"activeParameter", std::max(all[0].active, 0)}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// One edit of the lines that formatting changes; none for a text with syntax errors.
Json formatting(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json edits = Json::array();
  if (text->diagnostics.has_errors()) return edits;
  const std::string formatted = scene::format(text->text);
  if (formatted == text->text) return edits;
  const std::vector<std::string> before = lines_of(text->text), after = lines_of(formatted);
  const size_t shorter = std::min(before.size(), after.size());
  size_t first = 0, same = 0;
  while (first < shorter && before[first] == after[first]) ++first;
  while (same < shorter - first &&
         before[before.size() - 1 - same] == after[after.size() - 1 - same])
    ++same;
  if (text->text.ends_with('\n') != formatted.ends_with('\n')) same = 0;
  std::string inserted;
  for (size_t i = first; i < after.size() - same; ++i) inserted += after[i] + "\n";
  const language::Position begin{static_cast<int>(first) + 1, 1};
  const language::Position end{static_cast<int>(before.size() - same) + 1, 1};
  return session.documents.edits({{language::range_between(text->file, begin, end), inserted}});
}

Json code_actions(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const language::Position begin =
      session.documents.position(text->file, params.at("range").at("start"));
  const language::Position end =
      session.documents.position(text->file, params.at("range").at("end"));
  Json all = Json::array();
  const auto add = [&](const language::Fix& fix, const char* kind, const Json& solved) {
    Json action = {
        {"title", fix.title},
        {"kind", kind},
        {"edit",
         {{"changes", {{session.documents.uri(text->file), session.documents.edits(fix.edits)}}}}}};
    if (!solved.is_null()) action["diagnostics"] = {solved};
    all.push_back(std::move(action));
  };
  for (const Diagnostic& each : session.published.at(text->file, begin.line, end.line))
    for (const language::Fix& fix : language::fixes_for(*text, each))
      add(fix, "quickfix", to_json(session.documents, each));
  for (const language::Fix& fix : language::refactorings_at(*text, begin))
    add(fix, "refactor.extract", nullptr);
  return all;
}

Json colours(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json all = Json::array();
  for (const language::Swatch& each : language::swatches_of(*text))
    all.push_back(
        {{"range", session.documents.range(each.range)},
         {"color",
          {{"red", each.srgb.x}, {"green", each.srgb.y}, {"blue", each.srgb.z}, {"alpha", 1}}}});
  return all;
}

Json colour_presentations(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const Json& colour = params.at("color");
  const Vec3d srgb(colour.at("red"), colour.at("green"), colour.at("blue"));
  language::Swatch swatch;
  swatch.range = language::range_between(
      text->file, session.documents.position(text->file, params.at("range").at("start")),
      session.documents.position(text->file, params.at("range").at("end")));
  for (const language::Swatch& each : language::swatches_of(*text))
    if (each.range == swatch.range) swatch = each;
  Json all = Json::array();
  for (const std::string& each :
       language::colour_texts(swatch, srgb, language::is_code(*text, swatch.range)))
    all.push_back(
        {{"label", each},
         {"textEdit", {{"range", session.documents.range(swatch.range)}, {"newText", each}}}});
  return all;
}

}  // namespace

void add_editing(Answers& answers) {
  answers["textDocument/completion"] = completion;
  answers["textDocument/hover"] = hover;
  answers["textDocument/signatureHelp"] = signature_help;
  answers["textDocument/formatting"] = formatting;
  answers["textDocument/codeAction"] = code_actions;
  answers["textDocument/documentColor"] = colours;
  answers["textDocument/colorPresentation"] = colour_presentations;
}

}  // namespace vug::lsp
