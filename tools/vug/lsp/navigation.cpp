// SPDX-License-Identifier: Apache-2.0
// Answers about the uses of names: definition, references, highlights, rename, links.
#include "lsp/server.h"
#include "lsp/uri.h"

#include <vug/language/links.h>
#include <vug/language/navigation.h>
#include <vug/language/rename.h>

namespace vug::lsp {
namespace {

using language::AnalysisPtr;
using language::Reference;

Json definition(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const SourceLocation where = language::definition_at(*text, session.position(*text, params));
  return where.known() ? session.documents.location(where) : Json();
}

Json references(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const auto symbol = language::symbol_at(*text, session.position(*text, params));
  Json all = Json::array();
  if (!symbol) return all;
  const bool with_declaration = params.at("context").at("includeDeclaration");
  for (const Reference& each :
       language::references_of(session.documents.workspace(), *text, *symbol))
    if (with_declaration || !each.declares) all.push_back(session.documents.location(each.where));
  return all;
}

Json highlights(Session& session, const Json& params) {
  constexpr int kRead = 2, kWrite = 3;
  const AnalysisPtr text = session.analysis(params);
  const auto symbol = language::symbol_at(*text, session.position(*text, params));
  Json all = Json::array();
  if (!symbol) return all;
  for (const Reference& each : language::references_in(*text, *symbol))
    if (each.where.file == text->file)
      all.push_back({{"range", session.documents.range(each.where)},
                     {"kind", each.declares ? kWrite : kRead}});
  return all;
}

Json prepare_rename(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  const language::Position position = session.position(*text, params);
  const SourceLocation where = language::renamable_at(*text, position);
  return {{"range", session.documents.range(where)},
          {"placeholder", language::symbol_at(*text, position)->name}};
}

Json rename(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json changes = Json::object();
  for (const auto& [file, edits] :
       language::rename(session.documents.workspace(), *text, session.position(*text, params),
                        params.at("newName")))
    changes[session.documents.uri(file)] = session.documents.edits(edits);
  return {{"changes", std::move(changes)}};
}

Json links(Session& session, const Json& params) {
  const AnalysisPtr text = session.analysis(params);
  Json all = Json::array();
  for (const language::Link& each : language::links_of(session.documents.workspace(), *text))
    all.push_back({{"range", session.documents.range(each.range)},
                   {"target", session.documents.uri(each.target)}});
  return all;
}

}  // namespace

void add_navigation(Answers& answers) {
  answers["textDocument/definition"] = definition;
  answers["textDocument/references"] = references;
  answers["textDocument/documentHighlight"] = highlights;
  answers["textDocument/prepareRename"] = prepare_rename;
  answers["textDocument/rename"] = rename;
  answers["textDocument/documentLink"] = links;
}

}  // namespace vug::lsp
