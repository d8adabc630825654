// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/workbench/journal.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace vug::workbench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".vugjournal";

[[noreturn]] void fail(const fs::path& file, const char* doing) {
  throw Error(ErrorCode::io,
              fmt::format("cannot {} the journal '{}': {}", doing, file.string(), strerror(errno)),
              {}, "set $VUG_STATE_HOME to a folder that can be written");
}

void write_all(int descriptor, const fs::path& file, const std::string& text) {
  for (size_t at = 0; at < text.size();) {
    const ssize_t written = ::write(descriptor, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(file, "write");
    at += static_cast<size_t>(written);
  }
  if (::fsync(descriptor) != 0) fail(file, "write");
}

/// Whether a running program holds the lock of the journal.
bool is_locked(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return true;
  const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  ::close(descriptor);
  return locked;
}

/// The journals in a folder that a running program holds, or those that none does.
std::vector<fs::path> journal_files(const fs::path& folder, bool held) {
  std::vector<fs::path> out;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == kExtension && is_locked(entry.path()) == held)
      out.push_back(entry.path());
  return out;
}

std::vector<std::string> complete_lines(const std::string& text) {
  std::vector<std::string> out;
  for (size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    out.push_back(text.substr(at, end - at));
  return out;
}

}  // namespace

Journal::Journal(const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  for (int number = 0; descriptor_ < 0; ++number) {
    file_ = folder / fmt::format("{}-{}{}", ::getpid(), number, kExtension);
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600);
    if (descriptor_ < 0 && errno != EEXIST) fail(file_, "create");
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) fail(file_, "lock");
}

Journal::~Journal() {
  std::error_code ignored;
  fs::remove(file_, ignored);
  ::close(descriptor_);
}

void Journal::restart(const std::vector<std::string>& lines) {
  if (::ftruncate(descriptor_, 0) != 0) fail(file_, "shorten");
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  write_all(descriptor_, file_, text);
}

void Journal::append(const std::string& line) { write_all(descriptor_, file_, line + '\n'); }

std::vector<LostJournal> lost_journals(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, LostJournal>> found;
  for (const fs::path& file : journal_files(folder, false)) {
    LostJournal lost{file, complete_lines(read_text(file))};
    if (lost.lines.size() > 1) found.emplace_back(fs::last_write_time(file), std::move(lost));
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<LostJournal> out;
  for (auto& [time, lost] : found) out.push_back(std::move(lost));
  return out;
}

std::vector<std::string> held_opening_lines(const fs::path& folder, const fs::path& own) {
  std::vector<std::string> out;
  for (const fs::path& file : journal_files(folder, true)) {
    if (file == own) continue;
    std::vector<std::string> lines;
    try {
      lines = complete_lines(read_text(file));
    } catch (const Error&) {  // its program has just ended
      continue;
    }
    if (!lines.empty()) out.push_back(std::move(lines.front()));
  }
  return out;
}

fs::path journal_folder() {
  if (const char* own = std::getenv("VUG_STATE_HOME")) return own;
  if (const char* state = std::getenv("XDG_STATE_HOME")) return fs::path(state) / "vug";
  const char* home = std::getenv("HOME");
  return fs::path(home ? home : ".") / ".local/state/vug";
}

}  // namespace vug::workbench
