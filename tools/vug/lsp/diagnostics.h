// SPDX-License-Identifier: Apache-2.0
// Diagnostics for the client. A check of one document finds faults in the files that it includes,
// too; those of several documents are combined for each file.
#pragma once

#include "lsp/documents.h"

#include <vug/language/check.h>

namespace vug::lsp {

class PublishedDiagnostics {
 public:
  /// Replaces the faults that were found from a document and returns the notifications for the
  /// files whose faults may have changed.
  std::vector<Json> update(const Documents& documents, const std::filesystem::path& document,
                           const Diagnostics& found);
  /// Removes the faults that were found from a document.
  std::vector<Json> remove(const Documents& documents, const std::filesystem::path& document);
  /// The faults of a file that overlap a range of lines (from 1).
  std::vector<Diagnostic> at(const std::string& file, int first_line, int last_line) const;

 private:
  Json notification(const Documents& documents, const std::string& file) const;

  /// By file, then by the document from which they were found.
  std::map<std::string, std::map<std::filesystem::path, std::vector<Diagnostic>>> files_;
};

Json to_json(const Documents& documents, const Diagnostic& diagnostic);

}  // namespace vug::lsp
