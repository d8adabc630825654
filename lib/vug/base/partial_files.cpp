// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/partial_files.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <string_view>

namespace vug {
namespace fs = std::filesystem;

namespace {

std::string before_process(const std::string& name) { return fmt::format(".{}.", name); }
std::string after_process(const std::string& extension) {
  return fmt::format(".part{}", extension);
}

/// Parses a positive process id; 0 for any other text.
pid_t process_of(std::string_view text) {
  pid_t process = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), process);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() ? process : 0;
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

std::string partial_file_name(const std::string& name, const std::string& extension) {
  return fmt::format("{}{}{}", before_process(name), ::getpid(), after_process(extension));
}

std::vector<fs::path> stale_partial_files(const fs::path& folder, const std::string& name,
                                          const std::string& extension) {
  const std::string before = before_process(name), after = after_process(extension);
  std::vector<fs::path> out;
  std::error_code code;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, code), end;
       !code && entry != end; entry.increment(code)) {
    const std::string seen = entry->path().filename().string();
    if (seen.size() <= before.size() + after.size() || !seen.starts_with(before) ||
        !seen.ends_with(after))
      continue;
    const pid_t maker = process_of(
        std::string_view(seen).substr(before.size(), seen.size() - before.size() - after.size()));
    if (maker > 0 && is_gone(maker)) out.push_back(entry->path());
  }
  return out;
}

std::vector<fs::path> make_folders(const fs::path& folder) {
  std::vector<fs::path> made;
  std::error_code code;
  for (fs::path up = folder; !up.empty() && fs::status(up, code).type() == fs::file_type::not_found;
       up = up.parent_path())
    made.push_back(up);
  code.clear();
  if (!folder.empty()) fs::create_directories(folder, code);
  if (!code) return made;
  remove_empty_folders(made);
  throw Error(ErrorCode::io,
              fmt::format("cannot create folder '{}': {}", folder.string(), code.message()));
}

void remove_empty_folders(const std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (const fs::path& folder : folders) fs::remove(folder, ignored);
}

}  // namespace vug
