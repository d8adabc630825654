// Files that belong together: all of them appear, or none.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// A hidden folder within the one that files are for. On commit they all move there, over what has
/// their names; without it the hidden folder goes, and so do folders that were made for it.
/// What a killed process has left goes with the next of the same name.
class FileTransaction {
 public:
  /// Error(io) where the folders cannot be made. `name` tells apart what is written at a time.
  FileTransaction(std::filesystem::path folder, const std::string& name);
  ~FileTransaction();
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;

  /// Where files are written until then.
  const std::filesystem::path& path() const { return staging_; }
  /// Error(io), and nothing has moved, where there is no room for what links lead to.
  void commit();

 private:
  std::filesystem::path folder_, staging_;
  std::vector<std::filesystem::path> created_folders_;  ///< Folders, the innermost first.
};

}  // namespace vug::cli
