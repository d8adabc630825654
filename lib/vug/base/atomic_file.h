// Files that are whole or not there: written beside their target, renamed at the end.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// Makes the target's folder and in it an empty temporary file with the same extension, and moves
/// that over the target on commit. Without commit the temporary file and the folders that were made
/// are removed. A killed process leaves at most a dot-file behind, never a half-written target; see
/// require_writable.
/// Where the target is a link, what it points to is replaced; permissions of a replaced file stay.
class AtomicFile {
 public:
  /// Error(io) when the target cannot be written: a folder that cannot be made or forbids it, a
  /// target that is no regular file.
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
  int lock_ = -1;  ///< The temporary file, open and locked while it is ours.
  std::vector<std::filesystem::path> made_folders_;  ///< The innermost first.
  bool committed_ = false;
};

/// Error(io) where an AtomicFile of the target could not be made; leaves nothing behind. For asking
/// before long work whose result goes there. Also removes the temporary files of the same target
/// that killed processes have left: those that nobody has locked and whose process is gone.
void require_writable(const std::filesystem::path& target);
/// The same for all that a program is going to write. Error(bad_input) where one of them is among
/// the files that it reads, by whatever name, or two are the same file.
void require_outputs(const std::vector<std::filesystem::path>& outputs,
                     const std::vector<std::filesystem::path>& inputs);

/// Writes the whole text through an AtomicFile.
void write_text(const std::filesystem::path& target, std::string_view text);

/// Why the path cannot be read as a file: "no such file", "it is a folder", "it is a pipe", ...;
/// empty for a regular file. Ask before opening: a pipe that nobody writes to would wait for ever.
std::string why_no_file(const std::filesystem::path& source);

/// The path's extension with its dot, in small letters: people write .VDB too.
std::string extension_of(const std::filesystem::path& path);

/// Reads a whole regular file; Error(bad_input) names the path when it cannot be read.
std::string read_text(const std::filesystem::path& source);

}  // namespace vug
