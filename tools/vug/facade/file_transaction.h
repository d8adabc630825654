// SPDX-License-Identifier: Apache-2.0
// Writes several files as one transaction: either all of them appear, or none.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vug::cli {

/// A hidden staging folder inside the output folder. `commit` moves its files to the output folder
/// and replaces files of the same names. Without a commit the destructor removes the staging folder
/// and the folders that were created for it. Files left by a killed process are removed by the next
/// transaction of the same name.
class FileTransaction {
 public:
  /// Error(io) if the folders cannot be created. `name` distinguishes concurrent transactions.
  FileTransaction(std::filesystem::path folder, const std::string& name);
  ~FileTransaction();
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;

  /// The staging folder, into which files are written before the commit.
  const std::filesystem::path& path() const { return staging_; }
  /// Moves the files to the output folder. Error(io), with no file moved, if the target of a
  /// symbolic link has no space left.
  void commit();

 private:
  std::filesystem::path folder_, staging_;
  std::vector<std::filesystem::path> created_folders_;  ///< Created folders, innermost first.
};

}  // namespace vug::cli
