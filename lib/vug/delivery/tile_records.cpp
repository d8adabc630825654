// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/delivery/tile_records.h>

#include <utility>

namespace vug::delivery {
namespace {

using Json = nlohmann::ordered_json;
using Path = std::filesystem::path;

/// 0 for files that do not exist.
uintmax_t size_of_file(const Path& file) {
  std::error_code missing;
  const uintmax_t size = std::filesystem::file_size(file, missing);
  return missing ? 0 : size;
}

}  // namespace

TileRecords::TileRecords(Path folder, const Digest& key)
    : folder_(std::move(folder)), key_(key.hex()) {}

Path TileRecords::path_of(const std::string& name) const {
  return folder_ / ("." + name + ".tile");
}

std::optional<TileRecord> TileRecords::read(const std::string& name) const {
  const Path path = path_of(name);
  if (!unreadable_reason(path).empty()) return std::nullopt;
  const Json known = Json::parse(read_text(path), nullptr, false);
  if (!known.is_object() || known.value("key", "") != key_) return std::nullopt;
  TileRecord record{known.value("content", Json::object()), {}};
  const Json files = known.value("files", Json::object());
  for (const auto& [file, size] : files.items()) {
    if (size != size_of_file(folder_ / file)) return std::nullopt;
    record.files.push_back(file);
  }
  return record;
}

void TileRecords::write(const std::string& name, const TileRecord& record) const {
  Json files = Json::object();
  for (const std::string& file : record.files) files[file] = size_of_file(folder_ / file);
  const Json all = {{"key", key_}, {"files", std::move(files)}, {"content", record.content}};
  write_text(path_of(name), all.dump() + "\n");
}

void TileRecords::remove(const std::string& name) const {
  std::error_code ignored;
  std::filesystem::remove(path_of(name), ignored);
}

void remove_tile_records(const Path& folder) {
  std::error_code ignored;
  std::vector<Path> records;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with('.') && entry.path().extension() == ".tile")
      records.push_back(entry.path());
  for (const Path& record : records) std::filesystem::remove(record, ignored);
}

}  // namespace vug::delivery
