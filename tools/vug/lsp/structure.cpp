// SPDX-License-Identifier: Apache-2.0
// Answers about whole texts: outline, folding, highlighting, inlay hints, code lenses.
#include "lsp/convert.h"
#include "lsp/server.h"

#include <vug/language/inlay_hints.h>
#include <vug/language/outline.h>
#include <vug/language/semantic_tokens.h>

#include <algorithm>

namespace vug::lsp {
namespace {

using language::AnalysisPtr;

Json symbols(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json all = Json::array();
  for (const language::OutlineItem& each : language::outline_of(*text))
    all.push_back(to_json(each, session.documents));
  return all;
}

Json folds(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json all = Json::array();
  for (const language::Fold& each : language::folds_of(*text)) {
    Json fold = {{"startLine", each.first_line - 1}, {"endLine", each.last_line - 1}};
    if (each.comment) fold["kind"] = "comment";
    all.push_back(std::move(fold));
  }
  return all;
}

/// Five numbers for each token, relative to the one before.
Json tokens(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const TextIndex& index = session.documents.index(text->file);
  Json data = Json::array();
  ClientPosition last;
  for (const language::SemanticToken& each : language::semantic_tokens(*text)) {
    const ClientPosition begin = index.to_client(language::begin_of(each.where));
    const ClientPosition end = index.to_client(language::end_of(each.where));
    const bool same_line = begin.line == last.line;
    for (const int number :
         {begin.line - last.line, same_line ? begin.character - last.character : begin.character,
          end.character - begin.character, static_cast<int>(each.meaning), each.declares ? 1 : 0})
      data.push_back(number);
    last = begin;
  }
  return {{"data", std::move(data)}};
}

Json hints(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const TextIndex& index = session.documents.index(text->file);
  const int first = client_position(params.at("range").at("start")).line + 1;
  const int last = client_position(params.at("range").at("end")).line + 1;
  Json all = Json::array();
  for (const language::Hint& each : language::inlay_hints(*text, first, last))
    all.push_back({{"position", to_json(index.to_client(each.position))},
                   {"label", each.text},
                   {"tooltip", each.doc}});
  return all;
}

/// Commands that a client runs as `vug VERB FILE`.
Json lenses(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json all = Json::array();
  const auto add = [&](const SourceLocation& where, const char* title, const char* command,
                       const std::string& name) {
    all.push_back({{"range", session.documents.range(where)},
                   {"command",
                    {{"title", title},
                     {"command", command},
                     {"arguments", {session.documents.uri(text->file), name}}}}});
  };
  for (const language::Symbol& each : text->symbols.symbols) {
    if (each.where.file != text->file) continue;
    if (each.keyword == "render") {
      add(each.where, "Render", "vug.render", each.name);
      add(each.where, "Preview", "vug.preview", each.name);
    }
    if (each.keyword == "mesh") add(each.where, "Measure", "vug.measure", each.name);
  }
  return all;
}

}  // namespace

void add_structure(Answers& answers) {
  answers["textDocument/documentSymbol"] = symbols;
  answers["textDocument/foldingRange"] = folds;
  answers["textDocument/semanticTokens/full"] = tokens;
  answers["textDocument/inlayHint"] = hints;
  answers["textDocument/codeLens"] = lenses;
}

}  // namespace vug::lsp
