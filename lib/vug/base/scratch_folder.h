// SPDX-License-Identifier: Apache-2.0
// A temporary folder for intermediate files.
#pragma once

#include <filesystem>
#include <string>

namespace vug {

/// An empty folder in the system's temporary directory ($TMPDIR), private to this process; the
/// destructor removes it with its contents. The constructor throws Error(io) if it cannot be
/// created.
class ScratchFolder {
 public:
  /// `name` is the prefix of the folder's name, e.g. "vug_preview".
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace vug
