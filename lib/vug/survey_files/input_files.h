// SPDX-License-Identifier: Apache-2.0
// Files that a survey text names, e.g. by *include of Survex: finds and reads them within limits.
#pragma once

#include <vug/survey_files/format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::survey {

/// Error(bad_input) at `where` if files of `bytes` together exceed the limit of the options.
void require_size(size_t bytes, const ReadOptions& options, const SourceLocation& where);

class InputFiles {
 public:
  /// `first` is the file that the user named, of which `bytes` are in memory already.
  /// Error(bad_input) if they exceed the limit.
  InputFiles(const std::filesystem::path& first, size_t bytes, const ReadOptions& options);

  /// Reads a file that the file in progress names, and makes it the file in progress until `leave`.
  /// The name is relative to the folder of the naming file; '\' is a separator, too. The search
  /// continues with the extension appended, and with both in lower case. Throws Error(bad_input)
  /// at `where` if the file does not exist, lies outside of the root folder, is in progress
  /// already, or exceeds a limit.
  std::string enter(const std::string& name, const std::string& extension,
                    const SourceLocation& where);
  void leave() { files_.pop_back(); }

  /// All files so far, the first one first; a file that is named twice is there twice.
  const std::vector<std::filesystem::path>& all() const { return all_; }

  /// The file in progress.
  const std::filesystem::path& current() const { return files_.back(); }

 private:
  std::filesystem::path find(const std::string& name, const std::string& extension,
                             const SourceLocation& where) const;

  std::vector<std::filesystem::path> files_;  ///< The files in progress, the first one first.
  std::vector<std::filesystem::path> all_;
  std::filesystem::path root_;  ///< Empty: files may lie anywhere.
  size_t bytes_;                ///< The total of all files.
  ReadOptions options_;
  int count_ = 0;
};

}  // namespace vug::survey
