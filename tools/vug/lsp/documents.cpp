// SPDX-License-Identifier: Apache-2.0
#include "lsp/documents.h"

#include "lsp/uri.h"

#include <vug/scene/lexer.h>

#include <algorithm>

namespace vug::lsp {

namespace fs = std::filesystem;

ClientPosition client_position(const Json& position) {
  return {position.at("line").get<int>(), position.at("character").get<int>()};
}

Json to_json(const ClientPosition& position) {
  return {{"line", position.line}, {"character", position.character}};
}

fs::path Documents::open(const Json& params) {
  const Json& document = params.at("textDocument");
  const fs::path file = path_of(document.at("uri"));
  workspace_.open(file, document.at("text"));
  open_[file] = {document.at("uri"), document.value("version", 0)};
  indices_.clear();
  return file;
}

fs::path Documents::change(const Json& params) {
  const Json& document = params.at("textDocument");
  const fs::path file = path_of(document.at("uri"));
  const auto known = open_.find(file);
  if (known == open_.end()) return file;
  std::string text = workspace_.read(file).value_or("");
  for (const Json& change : params.at("contentChanges")) {
    std::string inserted = scene::normalise_text(change.at("text").get<std::string>());
    if (!change.contains("range")) {
      text = std::move(inserted);
      continue;
    }
    const TextIndex index(std::move(text), encoding_);
    const auto begin = index.from_client(client_position(change.at("range").at("start")));
    const auto end = index.from_client(client_position(change.at("range").at("end")));
    text = language::apply(index.text(), {{language::range_between("", begin, std::max(begin, end)),
                                           std::move(inserted)}});
  }
  workspace_.open(file, std::move(text));
  if (document.contains("version") && document["version"].is_number_integer())
    known->second.version = document["version"];
  indices_.clear();
  return file;
}

fs::path Documents::close(const Json& params) {
  const fs::path file = path_of(params.at("textDocument").at("uri"));
  workspace_.close(file);
  open_.erase(file);
  indices_.clear();
  return file;
}

std::string Documents::uri(const fs::path& file) const {
  if (const auto known = open_.find(file); known != open_.end()) return known->second.uri;
  for (const auto& [path, document] : open_)
    if (language::is_same_file(path, file)) return document.uri;
  return uri_of(file.is_absolute()                             ? file
                : file.string().find(':') != std::string::npos ? file
                                                               : fs::absolute(file));
}

const TextIndex& Documents::index(const fs::path& file) const {
  const auto known = indices_.find(file);
  if (known != indices_.end()) return known->second;
  std::string text = scene::normalise_text(workspace_.read(file).value_or(""));
  return indices_.emplace(file, TextIndex(std::move(text), encoding_)).first->second;
}

Json Documents::range(const std::string& file, const SourceLocation& where) const {
  const TextIndex& lines = index(file);
  const language::Position begin{std::max(where.line, 1), std::max(where.column, 1)};
  const language::Position end = where.has_end() ? language::end_of(where) : begin;
  return {{"start", to_json(lines.to_client(begin))}, {"end", to_json(lines.to_client(end))}};
}

Json Documents::range(const SourceLocation& where) const { return range(where.file, where); }

Json Documents::location(const SourceLocation& where) const {
  return {{"uri", uri(where.file)}, {"range", range(where)}};
}

Json Documents::edits(const std::vector<language::TextEdit>& edits) const {
  Json all = Json::array();
  for (const language::TextEdit& edit : edits)
    all.push_back({{"range", range(edit.range)}, {"newText", edit.text}});
  return all;
}

language::Position Documents::position(const fs::path& file, const Json& position) const {
  return index(file).from_client(client_position(position));
}

}  // namespace vug::lsp
