// SPDX-License-Identifier: Apache-2.0
#include "lsp/convert.h"

#include <fmt/format.h>

namespace vug::lsp {
namespace {

/// CompletionItemKind of the protocol.
int kind_of(language::CompletionKind kind) {
  using language::CompletionKind;
  switch (kind) {
    case CompletionKind::keyword:
      return 14;
    case CompletionKind::argument:
      return 10;
    case CompletionKind::choice:
      return 20;
    case CompletionKind::kind:
      return 7;
    case CompletionKind::function:
      return 3;
    case CompletionKind::declaration:
      return 18;
    case CompletionKind::symbol:
      return 22;
    case CompletionKind::module:
      return 9;
    case CompletionKind::unit:
      return 11;
    case CompletionKind::file:
      return 17;
    case CompletionKind::value:
      break;
  }
  return 6;
}

/// SymbolKind of the protocol.
int kind_of(language::SymbolKind kind) {
  using language::SymbolKind;
  switch (kind) {
    case SymbolKind::param:
      return 14;
    case SymbolKind::function:
      return 12;
    case SymbolKind::declaration:
      return 19;
    case SymbolKind::grammar:
      return 5;
    case SymbolKind::module:
      return 2;
    case SymbolKind::rule:
      return 6;
    case SymbolKind::table:
      return 3;
    default:
      return 13;
  }
}

}  // namespace

Json markdown(const std::string& text) { return {{"kind", "markdown"}, {"value", text}}; }

std::string plain_text(const std::string& snippet) {
  std::string out;
  for (size_t i = 0; i < snippet.size(); ++i) {
    if (snippet[i] == '\\' && i + 1 < snippet.size()) {
      out += snippet[++i];
    } else if (snippet[i] == '$' && i + 1 < snippet.size() && snippet[i + 1] == '{') {
      const size_t colon = snippet.find(':', i), end = snippet.find('}', i);
      if (colon == std::string::npos || end == std::string::npos) break;
      out += snippet.substr(colon + 1, end - colon - 1);
      i = end;
    } else if (snippet[i] == '$') {
      ++i;  // $0
    } else {
      out += snippet[i];
    }
  }
  return out;
}

Json to_json(const language::Completions& completions, const Documents& documents, bool snippets) {
  constexpr int kPlain = 1, kSnippet = 2;
  const Json range = documents.range(completions.range);
  Json items = Json::array();
  for (const language::Completion& each : completions.items) {
    Json item = {
        {"label", each.label},
        {"kind", kind_of(each.kind)},
        {"sortText", fmt::format("{}{}", each.rank, each.label)},
        {"insertTextFormat", snippets ? kSnippet : kPlain},
        {"textEdit",
         {{"range", range}, {"newText", snippets ? each.snippet : plain_text(each.snippet)}}}};
    if (!each.detail.empty()) item["detail"] = each.detail;
    if (!each.doc.empty()) item["documentation"] = markdown(each.doc);
    items.push_back(std::move(item));
  }
  return {{"isIncomplete", false}, {"items", std::move(items)}};
}

Json to_json(const language::OutlineItem& item, const Documents& documents) {
  Json children = Json::array();
  for (const language::OutlineItem& child : item.children)
    children.push_back(to_json(child, documents));
  return {{"name", item.name},
          {"detail", item.detail},
          {"kind", kind_of(item.kind)},
          {"range", documents.range(item.extent)},
          {"selectionRange", documents.range(item.where)},
          {"children", std::move(children)}};
}

}  // namespace vug::lsp
