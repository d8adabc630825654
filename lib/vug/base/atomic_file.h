// SPDX-License-Identifier: Apache-2.0
// Atomic file output: a temporary file next to the target, renamed when complete. Checks of input
// and output files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// Creates the target's folder and an empty temporary file with the same extension in it, and moves
/// that file over the target on commit. Without commit, the temporary file and the created folders
/// are removed. A killed process leaves at most a dot-file behind, never a half-written target; see
/// require_writable.
/// If the target is a symbolic link, the file that it points to is replaced. A replaced file keeps
/// its permissions.
class AtomicFile {
 public:
  /// Throws Error(io) if the target cannot be written: the folder cannot be created or is not
  /// writable, or the target is not a regular file; Error(bad_input) if it is a folder.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& path() const { return temporary_; }
  /// Flushes to disk and renames. Throws Error(io).
  void commit();

 private:
  [[noreturn]] void fail(const std::string& why);
  void discard();

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int lock_ = -1;  ///< Descriptor of the temporary file, locked while this object owns it.
  std::vector<std::filesystem::path> made_folders_;  ///< Created folders, innermost first.
  bool committed_ = false;
};

/// Throws Error(io) if an AtomicFile could not be created for the target; leaves nothing behind.
/// Call it before long work whose result is written there. Also removes stale temporary files of
/// the same target: those that are not locked and whose process no longer exists.
void require_writable(const std::filesystem::path& target);
/// Calls require_writable for all outputs of a program. Throws Error(bad_input) if an output is
/// also an input, under any name, or if two outputs are the same file.
void require_outputs(const std::vector<std::filesystem::path>& outputs,
                     const std::vector<std::filesystem::path>& inputs);

/// Writes the whole text through an AtomicFile.
void write_text(const std::filesystem::path& target, std::string_view text);

/// The reason why the path cannot be read as a file ("no such file", "it is a folder", "it is a
/// pipe", ...); empty for a regular file. Check before opening: a pipe without a writer blocks
/// forever.
std::string unreadable_reason(const std::filesystem::path& source);

/// The path's extension with its dot, in lower case (users also write .VDB).
std::string extension_of(const std::filesystem::path& path);

/// Reads a whole regular file. Throws Error(bad_input) with the path if it cannot be read.
std::string read_text(const std::filesystem::path& source);

}  // namespace vug
