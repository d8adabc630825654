// SPDX-License-Identifier: Apache-2.0
#include "lsp/diagnostics.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace vug::lsp {
namespace {

/// The location in a hint such as "the first is at cave.vug:3:7".
SourceLocation location_in(const std::string& hint) {
  const std::string words = "the first is at ";
  const size_t at = hint.find(words);
  if (at == std::string::npos) return {};
  const std::string rest = hint.substr(at + words.size(), hint.find(';', at) - at - words.size());
  const size_t column = rest.rfind(':');
  const size_t line = column == std::string::npos ? column : rest.rfind(':', column - 1);
  if (line == std::string::npos) return {};
  SourceLocation where{rest.substr(0, line), 0, 0};
  std::from_chars(rest.data() + line + 1, rest.data() + column, where.line);
  std::from_chars(rest.data() + column + 1, rest.data() + rest.size(), where.column);
  return where;
}

}  // namespace

Json to_json(const Documents& documents, const Diagnostic& diagnostic) {
  constexpr int kError = 1, kWarning = 2;
  const std::string& hint = diagnostic.hint;
  Json out = {{"range", documents.range(diagnostic.where)},
              {"severity", diagnostic.severity == Severity::error ? kError : kWarning},
              {"source", "vug"},
              {"message", diagnostic.message + (hint.empty() ? "" : "\nhint: " + hint)}};
  if (const SourceLocation other = location_in(hint); other.known())
    out["relatedInformation"] = {
        {{"location", documents.location(other)}, {"message", "the first declaration"}}};
  return out;
}

Json PublishedDiagnostics::notification(const Documents& documents, const std::string& file) const {
  Json list = Json::array();
  std::set<std::string> known;  // two documents may include the file
  if (const auto found = files_.find(file); found != files_.end())
    for (const auto& [document, faults] : found->second)
      for (const Diagnostic& each : faults) {
        Json made = to_json(documents, each);
        if (known.insert(made.dump(-1, ' ', false, Json::error_handler_t::replace)).second)
          list.push_back(std::move(made));
      }
  Json params = {{"uri", documents.uri(file)}, {"diagnostics", std::move(list)}};
  if (const auto open = documents.all().find(file); open != documents.all().end())
    params["version"] = open->second.version;
  return {{"jsonrpc", "2.0"},
          {"method", "textDocument/publishDiagnostics"},
          {"params", std::move(params)}};
}

std::vector<Json> PublishedDiagnostics::update(const Documents& documents,
                                               const std::filesystem::path& document,
                                               const Diagnostics& found) {
  std::set<std::string> changed = {document.generic_string()};
  for (auto& [file, faults] : files_)
    if (faults.erase(document) > 0) changed.insert(file);
  for (const Diagnostic& each : found.all()) {
    Diagnostic one = each;
    if (one.where.file.empty() || !documents.workspace().read(one.where.file))
      one.where = {document.generic_string(), 1, 1};
    changed.insert(one.where.file);
    files_[one.where.file][document].push_back(std::move(one));
  }
  std::vector<Json> notifications;
  for (const std::string& file : changed) notifications.push_back(notification(documents, file));
  return notifications;
}

std::vector<Json> PublishedDiagnostics::remove(const Documents& documents,
                                               const std::filesystem::path& document) {
  return update(documents, document, {});
}

std::vector<Diagnostic> PublishedDiagnostics::at(const std::string& file, int first_line,
                                                 int last_line) const {
  std::vector<Diagnostic> all;
  if (const auto found = files_.find(file); found != files_.end())
    for (const auto& [document, faults] : found->second)
      for (const Diagnostic& each : faults)
        if (each.where.line <= last_line &&
            std::max(each.where.line, each.where.end_line) >= first_line)
          all.push_back(each);
  return all;
}

}  // namespace vug::lsp
