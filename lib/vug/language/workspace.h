// SPDX-License-Identifier: Apache-2.0
// The texts that are open in an editor, and their analyses. An open text replaces the file of that
// name, also where other texts include it.
#pragma once

#include <vug/language/symbols.h>
#include <vug/scene/parser.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::language {

/// A text with the syntax tree of it and of the files that it includes. Immutable.
struct Analysis {
  Analysis() = default;
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  std::string file;                  ///< As the locations of the text name it.
  std::string text;                  ///< With "\n" as line ends.
  std::vector<scene::Token> tokens;  ///< Those of the text, with comments; views of `text`.
  scene::Document document;
  Diagnostics diagnostics;  ///< Faults of the syntax, in all files.
  SymbolTable symbols;
};
using AnalysisPtr = std::shared_ptr<const Analysis>;

struct WorkspaceOptions {
  std::vector<std::filesystem::path> include_folders;  ///< See scene::ParseOptions.
};

/// Not thread-safe; a copy can be used in another thread.
class Workspace {
 public:
  explicit Workspace(WorkspaceOptions options = {}) : options_(std::move(options)) {}

  /// Opens a text or replaces it.
  void open(const std::filesystem::path& file, std::string text);
  /// From now on, the file of that name counts.
  void close(const std::filesystem::path& file);
  bool is_open(const std::filesystem::path& file) const;
  /// Folders whose scenes may use the names of open texts: for references and renames.
  void add_folder(const std::filesystem::path& folder) { folders_.push_back(folder); }

  /// The open text, or that of the file; nothing if it cannot be read.
  std::optional<std::string> read(const std::filesystem::path& file) const;
  /// The analysis of a text, which is computed again if a text of the workspace has changed.
  /// Throws Error(bad_input) if the text can be read neither here nor from the file.
  AnalysisPtr analyse(const std::filesystem::path& file) const;
  /// The open texts, and the scenes below the folders that contain the word.
  std::vector<std::filesystem::path> files_with(const std::string& word) const;

  const WorkspaceOptions& options() const { return options_; }
  /// Reads texts as `read` does; the workspace must outlive it.
  scene::ParseOptions parse_options() const;

 private:
  struct Text {
    std::filesystem::path file;  ///< As it was opened.
    std::string text;
  };
  WorkspaceOptions options_;
  std::map<std::filesystem::path, Text> open_;  ///< By canonical path.
  std::vector<std::filesystem::path> folders_;
  mutable std::map<std::string, AnalysisPtr> analyses_;
};

/// Whether both paths name the same file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace vug::language
