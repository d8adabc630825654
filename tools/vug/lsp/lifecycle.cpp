// SPDX-License-Identifier: Apache-2.0
// The beginning of a session: the abilities of both sides.
#include "lsp/server.h"
#include "lsp/uri.h"

#include <vug/language/semantic_tokens.h>

namespace vug::lsp {
namespace {

/// The value below several keys, or null.
Json find(const Json& from, const std::vector<std::string>& keys) {
  Json at = from;
  for (const std::string& key : keys) {
    if (!at.is_object() || !at.contains(key)) return nullptr;
    at = at[key];
  }
  return at;
}

}  // namespace

Json capabilities(const Session& session) {
  const bool utf8 = session.documents.encoding() == Encoding::utf8;
  Json legend = Json::array();
  for (const char* name : language::meaning_names()) legend.push_back(name);
  return {{"positionEncoding", utf8 ? "utf-8" : "utf-16"},
          {"textDocumentSync", {{"openClose", true}, {"change", 2}}},
          {"completionProvider", {{"triggerCharacters", {".", "(", ",", ":", "\"", "/"}}}},
          {"hoverProvider", true},
          {"signatureHelpProvider",
           {{"triggerCharacters", {"(", ","}}, {"retriggerCharacters", {":"}}}},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"documentHighlightProvider", true},
          {"renameProvider", {{"prepareProvider", true}}},
          {"documentFormattingProvider", true},
          {"documentSymbolProvider", true},
          {"foldingRangeProvider", true},
          {"colorProvider", true},
          {"documentLinkProvider", {{"resolveProvider", false}}},
          {"inlayHintProvider", true},
          {"codeActionProvider", {{"codeActionKinds", {"quickfix", "refactor.extract"}}}},
          {"codeLensProvider", {{"resolveProvider", false}}},
          {"semanticTokensProvider",
           {{"legend", {{"tokenTypes", legend}, {"tokenModifiers", {"declaration"}}}},
            {"full", true}}}};
}

Json Server::initialize(const Json& params) {
  if (initialized_) throw RequestError{kInvalidRequest, "the server is initialised already"};
  const Json client = find(params, {"capabilities"});
  const Json encodings = find(client, {"general", "positionEncodings"});
  if (encodings.is_array())
    for (const Json& each : encodings)
      if (each == "utf-8") session_.documents.set_encoding(Encoding::utf8);
  const Json snippets =
      find(client, {"textDocument", "completion", "completionItem", "snippetSupport"});
  session_.snippets = snippets.is_boolean() && snippets.get<bool>();
  const Json folders = find(params, {"workspaceFolders"});
  if (folders.is_array())
    for (const Json& each : folders)
      session_.documents.workspace().add_folder(path_of(each.at("uri")));
  else if (const Json root = find(params, {"rootUri"}); root.is_string())
    session_.documents.workspace().add_folder(path_of(root));
  initialized_ = true;
  return {{"capabilities", capabilities(session_)},
          {"serverInfo", {{"name", "vug"}, {"version", VUG_VERSION}}}};
}

}  // namespace vug::lsp
