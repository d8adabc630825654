// SPDX-License-Identifier: Apache-2.0
// The documents of a client: their texts, versions and positions.
#pragma once

#include "lsp/text_index.h"

#include <vug/language/workspace.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace vug::lsp {

using Json = nlohmann::ordered_json;

struct OpenDocument {
  std::string uri;  ///< As the client writes it.
  int version = 0;
};

class Documents {
 public:
  explicit Documents(language::WorkspaceOptions options) : workspace_(std::move(options)) {}

  void set_encoding(Encoding encoding) { encoding_ = encoding; }
  Encoding encoding() const { return encoding_; }
  language::Workspace& workspace() { return workspace_; }
  const language::Workspace& workspace() const { return workspace_; }

  /// The notifications textDocument/didOpen, didChange and didClose. A change of a document that is
  /// not open is ignored. Return the path of the document.
  std::filesystem::path open(const Json& params);
  std::filesystem::path change(const Json& params);
  std::filesystem::path close(const Json& params);

  const std::map<std::filesystem::path, OpenDocument>& all() const { return open_; }
  /// The URI that the client uses for a file.
  std::string uri(const std::filesystem::path& file) const;
  /// The lines of a text or a file; those of an empty text if it cannot be read.
  const TextIndex& index(const std::filesystem::path& file) const;

  Json range(const SourceLocation& where) const;
  Json range(const std::string& file, const SourceLocation& where) const;
  Json location(const SourceLocation& where) const;
  Json edits(const std::vector<language::TextEdit>& edits) const;
  language::Position position(const std::filesystem::path& file, const Json& position) const;

 private:
  language::Workspace workspace_;
  Encoding encoding_ = Encoding::utf16;
  std::map<std::filesystem::path, OpenDocument> open_;
  mutable std::map<std::filesystem::path, TextIndex> indices_;
};

/// The position in the parameters of a request.
ClientPosition client_position(const Json& position);
Json to_json(const ClientPosition& position);

}  // namespace vug::lsp
