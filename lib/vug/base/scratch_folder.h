// A folder of one's own for files on the way to somewhere else.
#pragma once

#include <filesystem>
#include <string>

namespace vug {

/// Made empty, for this process alone, where the system keeps such files ($TMPDIR); it goes with
/// all that is in it when this does. Error(io) where it cannot be made.
class ScratchFolder {
 public:
  /// `name` says whose it is, for who looks there: "vug_preview".
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
