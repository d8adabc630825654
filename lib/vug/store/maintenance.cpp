// SPDX-License-Identifier: Apache-2.0
#include <vug/store/layout.h>
#include <vug/store/maintenance.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <system_error>
#include <vector>

namespace vug::store {

namespace fs = std::filesystem;

namespace {

struct File {
  fs::path path;
  uint64_t bytes = 0;
  fs::file_time_type used;
};

/// The files below a folder, of which other processes may remove some at any time.
std::vector<File> files_below(const fs::path& folder) {
  std::vector<File> out;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code gone;
    if (!it->is_regular_file(gone)) continue;
    const File file{it->path(), it->file_size(gone), it->last_write_time(gone)};
    if (!gone) out.push_back(file);
  }
  return out;
}

/// Removes the least recently used files until at most `most` bytes remain.
TrimReport remove_oldest(std::vector<File> files, uint64_t most) {
  TrimReport out;
  uint64_t bytes = 0;
  for (const File& file : files) bytes += file.bytes;
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) {
    return a.used != b.used ? a.used < b.used : a.path < b.path;
  });
  for (const File& file : files) {
    if (bytes <= most) break;
    bytes -= file.bytes;
    if (!discard(file.path)) continue;
    ++out.files;
    out.bytes += file.bytes;
  }
  return out;
}

std::optional<Action> action_in(const File& file) {
  const auto text = read_sealed(file.path);
  return text ? parse_action(*text) : std::nullopt;
}

}  // namespace

void trim_shard(const fs::path& store, const std::string& object, uint64_t max_bytes) {
  constexpr uint64_t kShards = 16;
  const uint64_t most = max_bytes / kShards;
  std::vector<File> files;
  uint64_t bytes = 0, own = 0;
  for (const char second : std::string("0123456789abcdef"))
    for (File& file : files_below(store / kObjects / (object.substr(0, 1) + second))) {
      bytes += file.bytes;
      if (file.path.filename() == object)
        own = file.bytes;
      else
        files.push_back(std::move(file));
    }
  const uint64_t wanted = most / 10 * 8;
  if (bytes > most) remove_oldest(std::move(files), wanted > own ? wanted - own : 0);
}

StoreStatistics statistics(const fs::path& folder) {
  StoreStatistics out;
  for (const File& file : files_below(folder / kObjects)) ++out.files, out.bytes += file.bytes;
  for (const File& file : files_below(folder / kActions))
    if (const auto action = action_in(file)) {
      KindStatistics& kind = out.kinds[action->kind];
      ++kind.products;
      kind.bytes += action->bytes;
      kind.seconds += action->seconds;
    }
  return out;
}

TrimReport trim(const fs::path& folder, uint64_t max_bytes) {
  const TrimReport out = remove_oldest(files_below(folder / kObjects), max_bytes);
  const auto now = fs::file_time_type::clock::now();
  for (const File& file : files_below(folder / kTemporary))
    if (now - file.used > std::chrono::hours(24)) discard(file.path);
  std::error_code ignored;
  for (const File& file : files_below(folder / kActions)) {
    const auto action = action_in(file);
    if (!action || !fs::exists(file_of(folder, kObjects, action->object), ignored))
      discard(file.path);
  }
  for (const File& file : files_below(folder / kNames))
    if (now - file.used > std::chrono::hours(24 * 90)) discard(file.path);
  return out;
}

VerifyReport verify(const fs::path& folder) {
  VerifyReport out;
  const auto count = [&](const File& file, bool intact) {
    if (!intact) discard(file.path);
    ++(intact ? out.intact : out.damaged);
  };
  for (const File& file : files_below(folder / kObjects))
    count(file, is_intact(file.path, file.path.stem()));
  for (const File& file : files_below(folder / kActions)) count(file, action_in(file).has_value());
  for (const File& file : files_below(folder / kNames))
    count(file, read_sealed(file.path).has_value());
  return out;
}

}  // namespace vug::store
