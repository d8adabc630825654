#include "together.h"

#include <fmt/format.h>
#include <unistd.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <memory>
#include <vector>

namespace vug::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kEnd = ".part";

/// Hidden folders of that name whose process is gone.
void remove_stale(const fs::path& folder, const std::string& begin) {
  std::error_code ignored;
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin) || !name.ends_with(kEnd) || !entry.is_directory(ignored)) continue;
    const char* last = name.data() + name.size() - kEnd.size();
    pid_t maker = 0;
    const auto read = std::from_chars(name.data() + begin.size(), last, maker);
    if (read.ec == std::errc() && read.ptr == last && maker > 0 && ::kill(maker, 0) != 0 &&
        errno == ESRCH)
      stale.push_back(entry.path());
  }
  for (const fs::path& each : stale) fs::remove_all(each, ignored);
}

}  // namespace

Together::Together(fs::path folder, const std::string& name)
    : folder_(folder.empty() ? "." : std::move(folder)) {
  const std::string begin = fmt::format(".{}.", name);
  hidden_ = folder_ / fmt::format("{}{}{}", begin, ::getpid(), kEnd);
  std::error_code code;
  for (fs::path up = folder_; !up.empty() && !fs::exists(up, code); up = up.parent_path())
    made_.push_back(up);
  remove_stale(folder_, begin);
  fs::create_directories(hidden_, code);
  if (code)
    throw Error(ErrorCode::io,
                fmt::format("cannot make folder '{}': {}", hidden_.string(), code.message()));
}

Together::~Together() {
  std::error_code ignored;
  fs::remove_all(hidden_, ignored);
  for (const fs::path& each : made_) fs::remove(each, ignored);  // only empty ones go
}

void Together::commit() {
  std::vector<std::unique_ptr<AtomicFile>> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(hidden_)) {
    files.push_back(std::make_unique<AtomicFile>(folder_ / entry.path().filename()));
    const fs::path& beside = files.back()->path();
    std::error_code code;
    fs::rename(entry.path(), beside, code);
    if (!code) continue;
    // A link has led to another disk.
    fs::copy_file(entry.path(), beside, fs::copy_options::overwrite_existing, code);
    if (code)
      throw Error(ErrorCode::io,
                  fmt::format("cannot write '{}': {}", beside.string(), code.message()));
  }
  for (const auto& file : files) file->commit();
}

}  // namespace vug::cli
