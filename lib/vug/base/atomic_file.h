// Files that are whole or not there: written beside their target, renamed at the end.
#pragma once

#include <filesystem>
#include <string_view>

namespace vug {

/// Makes the target's folder, gives a temporary path in it with the same extension, and moves it
/// over the target on commit. Without commit the temporary file is removed. A killed process
/// leaves at most a dot-file behind, never a half-written target.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& path() const { return temporary_; }
  /// Flushes to disk and renames. Throws Error(io).
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Writes the whole text through an AtomicFile.
void write_text(const std::filesystem::path& target, std::string_view text);

/// Why the path cannot be read as a file: "no such file", "it is a folder", "it is a pipe", ...;
/// empty for a regular file. Ask before opening: a pipe that nobody writes to would wait for ever.
std::string why_no_file(const std::filesystem::path& source);

/// Reads a whole regular file; Error(bad_input) names the path when it cannot be read.
std::string read_text(const std::filesystem::path& source);

}  // namespace vug
